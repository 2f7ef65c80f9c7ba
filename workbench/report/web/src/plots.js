// Plots over time: the time axes zoom together, a click goes to that time, a line stands at the time shown.

import uPlot from "uplot";
import { chartData, chartOptions, createLegend, kHeight } from "./chart.js";
import { onThemeChange } from "./theme.js";

const kFirstPlots = 6;
const kMostCurves = 8; // as many colours as there are
const kLeastWidth = 120;
const kClick = 3; // px that a press may move and still be a click

/** Groups of columns that a page begins with: the outputs by quantity, without outputs the coordinates by unit. */
export function firstPlots(table) {
  const ofGroup = (group) => table.columns.flatMap((column, c) => (column.group === group ? [c] : []));
  const outputs = ofGroup("output");
  const groups = new Map();
  (outputs.length > 0 ? outputs : ofGroup("coordinate")).forEach((c) => {
    const { unit, quantity } = table.columns[c];
    const key = `${unit} ${quantity ?? ""}`;
    groups.set(key, [...(groups.get(key) ?? []), c].slice(0, kMostCurves));
  });
  return [...groups.values()].slice(0, kFirstPlots);
}

function button(label, title, action) {
  const result = Object.assign(document.createElement("button"), { type: "button", textContent: label, title });
  result.setAttribute("aria-label", title);
  result.addEventListener("click", action);
  return result;
}

/** A press that ends where it began goes to that time; one that moved has zoomed. */
function seekByClick(chart, player) {
  let pressed = null;
  chart.over.addEventListener("mousedown", (event) => {
    pressed = event.clientX;
  });
  chart.over.addEventListener("click", (event) => {
    if (pressed === null || Math.abs(event.clientX - pressed) > kClick) return;
    player.seek(chart.posToVal(event.clientX - chart.over.getBoundingClientRect().left, "x"));
  });
}

/** The line and the values of a plot at a time; what the mouse points at goes before. */
function showTime(plot, time) {
  const { min, max } = plot.chart.scales.x;
  plot.marker.hidden = time < min || time > max;
  plot.marker.style.transform = `translateX(${plot.chart.valToPos(time, "x")}px)`;
  plot.legend.show(plot.hover ?? time);
}

/** Plots of a table in an element, tied to a player. onEdit(columns, done) lets people choose columns. */
export function createPlots(table, player, element, onEdit) {
  const plots = [];
  const { key } = uPlot.sync("time");
  const width = (plot) => Math.max(kLeastWidth, plot.box.clientWidth);
  const showAll = () => plots.forEach((plot) => showTime(plot, player.state.time));

  /** Takes a zoom over to the charts that do not have it: each tells of its own, and then all have it. */
  function zoomAll({ min, max }) {
    plots.filter(({ chart }) => chart.scales.x.min !== min || chart.scales.x.max !== max)
      .forEach(({ chart }) => chart.setScale("x", { min, max }));
    showAll();
  }

  function head(plot, columns) {
    const box = document.createElement("div");
    box.className = "plot-head";
    const names = columns.map(({ name }) => name).join(", ");
    const edit = () => onEdit(plot.columns, (chosen) => {
      plot.columns = chosen;
      draw(plot);
    });
    box.append(
      plot.legend.list,
      button("Edit", `choose the columns of this plot, now ${names}`, edit),
      button("Remove", `remove the plot of ${names}`, () => remove(plot)),
    );
    return box;
  }

  function draw(plot) {
    const columns = plot.columns.map((c) => table.columns[c]);
    const others = plots.find((other) => other !== plot && other.chart);
    plot.chart?.destroy();
    plot.legend = createLegend(table.times, columns);
    plot.box.replaceChildren(head(plot, columns));
    plot.marker = Object.assign(document.createElement("div"), { className: "marker" });
    plot.chart = null; // its first scale is not a zoom
    const chart = new uPlot(chartOptions(columns, width(plot), key, {
      setScale: [(u, axis) => axis === "x" && plot.chart && zoomAll(u.scales.x)],
      setCursor: [(u) => {
        plot.hover = u.cursor.left >= 0 ? u.posToVal(u.cursor.left, "x") : null;
        plot.legend.show(plot.hover ?? player.state.time);
      }],
    }), chartData(table.times, columns), plot.box);
    plot.chart = chart;
    chart.over.append(plot.marker);
    seekByClick(chart, player);
    if (others) chart.setScale("x", { min: others.chart.scales.x.min, max: others.chart.scales.x.max });
    showTime(plot, player.state.time);
  }

  function remove(plot) {
    plot.chart.destroy();
    plot.box.remove();
    plots.splice(plots.indexOf(plot), 1);
  }

  function add(columns) {
    const box = Object.assign(document.createElement("figure"), { className: "plot" });
    element.append(box);
    const plot = { columns, box, chart: null, legend: null, marker: null, hover: null };
    draw(plot);
    plots.push(plot);
  }

  player.listen(showAll);
  onThemeChange(() => plots.forEach(draw));
  new ResizeObserver(() => {
    plots.forEach((plot) => plot.chart.setSize({ width: width(plot), height: kHeight }));
    showAll();
  }).observe(element);

  return {
    add,
    resetZoom: () => plots[0]?.chart.setScale("x", { min: table.times[0], max: table.times[table.rows - 1] }),
    plots,
  };
}
