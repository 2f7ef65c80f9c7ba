// One chart of uPlot: how columns are shown, its axes and its legend.

import uPlot from "uplot";
import { valueAt } from "./data.js";
import { inDegrees } from "./numbers.js";
import { colour, curveColour } from "./theme.js";

export const kHeight = 168;
const kLargeFrom = 2000;
const kDashes = [[6, 3], [2, 2], [9, 3, 2, 3]]; // of the second result, the third, the fourth
const kFont = "11px system-ui, sans-serif";

/** Factor and unit as a column is shown: angles in degrees, large forces in kilo. */
export function shownUnit({ unit, smallest, largest }) {
  const degrees = inDegrees(unit);
  if (degrees.factor !== 1) return degrees;
  const size = Math.max(Math.abs(smallest), Math.abs(largest));
  if (["N", "N m", "Pa", "J", "W"].includes(unit) && size >= kLargeFrom) return { factor: 1e-3, unit: `k${unit}` };
  return { factor: 1, unit };
}

function formatted(value, noise) {
  if (Number.isNaN(value)) return ""; // another result has ended
  const size = Math.abs(value);
  if (size < noise) return "0";
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) return value.toExponential(2);
  return value.toPrecision(4);
}

/** A number of an axis: what is zero but for rounding has no sign. */
function tickText(value, step) {
  return `${Math.abs(value) < 1e-6 * step ? 0 : Number(value.toPrecision(6))}`;
}

/** Limits of an axis whose curves go from low to high: what is less than `noise` is no motion and fills no panel. */
export function limits(low, high, noise) {
  if (high - low > noise) return uPlot.rangeNum(low, high, 0.1, true);
  const middle = (low + high) / 2;
  const half = Math.abs(middle) > noise ? 0.1 * Math.abs(middle) : 1;
  return Math.abs(middle) > noise ? [middle - half, middle + half] : [-half, half];
}

function axes(unit) {
  const line = { stroke: colour("line"), width: 1 };
  const common = { stroke: colour("soft"), grid: line, ticks: { ...line, size: 4 }, font: kFont };
  return [
    { ...common, space: 60, size: 24, values: (u, splits, axis, space, step) => splits.map((t) => tickText(t, step)) },
    { ...common, values: (u, splits, axis, space, step) => splits.map((y) => tickText(y, step)), size: 52, space: 26, label: unit || undefined, labelSize: 14, labelGap: 0, labelFont: kFont },
  ];
}

/** Options of uPlot for some columns; charts of one key show their cursors together. */
export function chartOptions(columns, width, key, hooks) {
  const noise = shownUnit(columns[0]).factor * Math.max(...columns.map((column) => column.noise));
  return {
    width,
    height: kHeight,
    legend: { show: false },
    scales: { x: { time: false }, y: { range: (u, low, high) => (low === null ? [0, 1] : limits(low, high, noise)) } },
    axes: axes(shownUnit(columns[0]).unit),
    series: [{}, ...columns.map(({ name, other }, i) => ({
      label: name, stroke: curveColour(i), width: 1.5, pxAlign: 0, points: { show: false }, dash: other ? kDashes[(other - 1) % kDashes.length] : undefined,
    }))],
    cursor: { sync: { key, setSeries: false }, drag: { x: true, y: false, setScale: true }, points: { size: 6 } },
    hooks,
  };
}

/** Values of columns as they are shown, for uPlot. */
export function chartData(times, columns) {
  return [times, ...columns.map((column) => {
    const { factor } = shownUnit(column);
    if (column.other) return Array.from(column.values, (value) => (Number.isNaN(value) ? null : factor * value));
    return factor === 1 ? column.values : column.values.map((value) => factor * value);
  })];
}

/** A list of names with their values at a time. */
export function createLegend(times, columns) {
  const list = document.createElement("ul");
  list.className = "legend";
  const values = columns.map(({ name }, i) => {
    const item = document.createElement("li");
    const swatch = document.createElement("i");
    swatch.style.background = curveColour(i);
    const value = document.createElement("output");
    item.append(swatch, name, value);
    list.append(item);
    return value;
  });
  return {
    list,
    show(time) {
      columns.forEach((column, i) => {
        const { factor, unit } = shownUnit(column);
        values[i].textContent = `${formatted(factor * valueAt(times, column.values, time), factor * column.noise)} ${unit}`;
      });
    },
  };
}
