// Plots over time with uPlot: the time axes zoom together, a click goes to that time, a line stands at the time shown.

import uPlot from "uplot";
import { valueAt } from "./data.js";
import { colour, curveColour, onThemeChange } from "./theme.js";

const kDegrees = 180 / Math.PI;
const kHeight = 168;
const kFirstPlots = 6;
const kLargeFrom = 2000;

/** Factor and unit as a column is shown: angles in degrees, large forces in kilo. */
function shownUnit(column) {
  const { unit } = column;
  if (unit === "rad" || unit.startsWith("rad/")) return { factor: kDegrees, unit: unit.replace("rad", "deg") };
  const largest = Math.max(Math.abs(column.smallest), Math.abs(column.largest));
  if (["N", "N m", "Pa", "J", "W"].includes(unit) && largest >= kLargeFrom) return { factor: 1e-3, unit: `k${unit}` };
  return { factor: 1, unit };
}

/** Groups of columns that a page begins with: the outputs by unit, without outputs the coordinates. */
export function firstPlots(table) {
  const outputs = table.columns.flatMap((column, c) => (column.group === "output" ? [c] : []));
  const wanted = outputs.length > 0 ? outputs : table.columns.flatMap((column, c) => (column.group === "coordinate" ? [c] : []));
  const groups = new Map();
  wanted.forEach((c) => {
    const { unit } = table.columns[c];
    groups.set(unit, [...(groups.get(unit) ?? []), c].slice(0, 8));
  });
  return [...groups.values()].slice(0, kFirstPlots);
}

function formatted(value) {
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) return value.toExponential(2);
  return value.toPrecision(4);
}

function axes(unit) {
  const common = { stroke: colour("soft"), grid: { stroke: colour("line"), width: 1 }, ticks: { stroke: colour("line"), width: 1, size: 4 }, font: "11px system-ui, sans-serif" };
  return [
    { ...common, space: 60, size: 24, values: (u, splits) => splits.map((t) => `${Number(t.toPrecision(6))}`) },
    { ...common, size: 52, space: 26, label: unit || undefined, labelSize: 14, labelGap: 0, labelFont: "11px system-ui, sans-serif" },
  ];
}

/** Plots of a table in an element, tied to a player. onEdit(columns, done) lets people choose columns. */
export function createPlots(table, player, element, onEdit) {
  const plots = [];
  const sync = uPlot.sync("time");
  let zooming = false;

  function zoomAll(from, min, max) {
    if (zooming) return;
    zooming = true;
    plots.forEach((plot) => plot !== from && plot.chart.setScale("x", { min, max }));
    zooming = false;
    placeMarkers(player.state);
  }

  function showValues(plot, time) {
    plot.values.forEach((output, i) => {
      const column = table.columns[plot.columns[i]];
      const { factor, unit } = shownUnit(column);
      output.textContent = `${formatted(factor * valueAt(table.times, column.values, time))} ${unit}`;
    });
  }

  function placeMarkers({ time }) {
    plots.forEach((plot) => {
      const { min, max } = plot.chart.scales.x;
      const left = plot.chart.valToPos(time, "x");
      plot.marker.hidden = time < min || time > max;
      plot.marker.style.transform = `translateX(${left}px)`;
      showValues(plot, plot.hover ?? time);
    });
  }

  function legend(plot) {
    const list = document.createElement("ul");
    list.className = "legend";
    plot.values = plot.columns.map((c, i) => {
      const item = document.createElement("li");
      const swatch = document.createElement("i");
      swatch.style.background = curveColour(i);
      const value = document.createElement("output");
      item.append(swatch, table.columns[c].name, value);
      list.append(item);
      return value;
    });
    return list;
  }

  function button(label, title, action) {
    const result = document.createElement("button");
    result.type = "button";
    result.textContent = label;
    result.title = title;
    result.setAttribute("aria-label", title);
    result.addEventListener("click", action);
    return result;
  }

  function draw(plot) {
    plot.chart?.destroy();
    const { columns } = plot;
    const unit = shownUnit(table.columns[columns[0]]).unit;
    const head = document.createElement("div");
    head.className = "plot-head";
    head.append(
      legend(plot),
      button("Edit", `choose the columns of this plot, now ${columns.map((c) => table.columns[c].name).join(", ")}`, () => onEdit(plot.columns, (chosen) => {
        plot.columns = chosen;
        draw(plot);
      })),
      button("Remove", "remove this plot", () => remove(plot)),
    );
    plot.box.replaceChildren(head);
    const data = [table.times, ...columns.map((c) => {
      const { factor } = shownUnit(table.columns[c]);
      return factor === 1 ? table.columns[c].values : table.columns[c].values.map((value) => factor * value);
    })];
    plot.chart = new uPlot({
      width: Math.max(120, plot.box.clientWidth),
      height: kHeight,
      legend: { show: false },
      scales: { x: { time: false } },
      axes: axes(unit),
      series: [{}, ...columns.map((c, i) => ({ label: table.columns[c].name, stroke: curveColour(i), width: 1.5, points: { show: false } }))],
      cursor: { sync: { key: sync.key, setSeries: false }, drag: { x: true, y: false, setScale: true }, points: { size: 6 } },
      hooks: {
        setScale: [(u, key) => key === "x" && zoomAll(plot, u.scales.x.min, u.scales.x.max)],
        setCursor: [(u) => {
          plot.hover = u.cursor.left >= 0 ? u.posToVal(u.cursor.left, "x") : null;
          showValues(plot, plot.hover ?? player.state.time);
        }],
      },
    }, data, plot.box);
    plot.marker = document.createElement("div");
    plot.marker.className = "marker";
    plot.chart.over.append(plot.marker);
    seekByClick(plot);
    const first = plots.find((other) => other !== plot && other.chart);
    if (first) plot.chart.setScale("x", { ...first.chart.scales.x });
    placeMarkers(player.state);
  }

  /** A press that ends where it began goes to that time; one that moved has zoomed. */
  function seekByClick(plot) {
    let pressed = null;
    const over = plot.chart.over;
    over.addEventListener("mousedown", (event) => {
      pressed = event.clientX;
    });
    over.addEventListener("click", (event) => {
      if (pressed === null || Math.abs(event.clientX - pressed) > 3) return;
      player.seek(plot.chart.posToVal(event.clientX - over.getBoundingClientRect().left, "x"));
    });
  }

  function remove(plot) {
    plot.chart.destroy();
    plot.box.remove();
    plots.splice(plots.indexOf(plot), 1);
  }

  function add(columns) {
    const box = document.createElement("figure");
    box.className = "plot";
    element.append(box);
    const plot = { columns, box, chart: null, marker: null, values: [], hover: null };
    plots.push(plot);
    draw(plot);
    return plot;
  }

  player.listen(placeMarkers);
  onThemeChange(() => plots.forEach(draw));
  new ResizeObserver(() => {
    plots.forEach((plot) => plot.chart.setSize({ width: Math.max(120, plot.box.clientWidth), height: kHeight }));
    placeMarkers(player.state);
  }).observe(element);

  return {
    add,
    resetZoom: () => plots.length > 0 && plots[0].chart.setScale("x", { min: table.times[0], max: table.times[table.rows - 1] }),
    plots,
  };
}
