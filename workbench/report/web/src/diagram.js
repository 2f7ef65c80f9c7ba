// A diagram of curves over a quantity that is not time.

import { inDegrees, shortNumber } from "./numbers.js";
import { piece, ticks } from "./svg.js";
import { curveColour, onThemeChange } from "./theme.js";

const kWidth = 460;
const kHeight = 210;
const kMargin = { left: 46, right: 12, top: 18, bottom: 34 };
const kRoom = 0.04; // of the range, beyond its ends

/** A heading with its values' factor, from SI units. */
function shown({ name, unit }) {
  const { factor, unit: as } = inDegrees(unit);
  return { factor, unit: as, text: as && as !== "1" ? `${name}, ${as}` : name };
}

/** Limits of an axis for some values, null among them. */
function limits(values) {
  const known = values.filter((value) => value !== null);
  const low = Math.min(...known);
  const high = Math.max(...known);
  const room = high > low ? kRoom * (high - low) : Math.abs(low) || 1;
  return [low - room, high + room];
}

function scale([from, to], start, length) {
  return (value) => start + (length * (value - from)) / (to - from);
}

/** A curve as a path, broken where a value is null. */
function pathOf({ x, y }, toX, toY) {
  let isDown = false;
  return x.map((value, i) => {
    if (value === null || y[i] === null) {
      isDown = false;
      return "";
    }
    const step = `${isDown ? "L" : "M"}${toX(value).toFixed(1)} ${toY(y[i]).toFixed(1)}`;
    isDown = true;
    return step;
  }).join("");
}

function axes(across, up, rangeX, rangeY, toX, toY) {
  const right = kWidth - kMargin.right;
  const bottom = kHeight - kMargin.bottom;
  const line = (x1, y1, x2, y2, value) => piece("line", { x1, y1, x2, y2, class: value === 0 ? "axis" : "grid" });
  return [
    ...ticks(...rangeX, 6).flatMap((value) => [
      line(toX(value), kMargin.top, toX(value), bottom, value),
      piece("text", { x: toX(value), y: bottom + 13, "text-anchor": "middle" }, shortNumber(value)),
    ]),
    ...ticks(...rangeY).flatMap((value) => [
      line(kMargin.left, toY(value), right, toY(value), value),
      piece("text", { x: kMargin.left - 4, y: toY(value) + 3, "text-anchor": "end" }, shortNumber(value)),
    ]),
    piece("text", { x: right, y: kHeight - 5, "text-anchor": "end" }, across.text),
    piece("text", { x: 4, y: kMargin.top - 7 }, up.text),
  ];
}

function legend(curves) {
  const list = document.createElement("ul");
  list.className = "legend";
  curves.forEach(({ name }) => {
    const item = document.createElement("li");
    item.append(document.createElement("i"), name);
    list.append(item);
  });
  return list;
}

/** A figure of a diagram of the data: title, headings x and y, curves. */
export function createDiagram({ title, x, y, curves }) {
  const [across, up] = [shown(x), shown(y)];
  const scaled = (values, factor) => values.map((value) => (value === null ? null : factor * value));
  const lines = curves.map((curve) => ({ x: scaled(curve.x, across.factor), y: scaled(curve.y, up.factor) }));
  const rangeX = limits(lines.flatMap((line) => line.x));
  const rangeY = limits(lines.flatMap((line) => line.y));
  const toX = scale(rangeX, kMargin.left, kWidth - kMargin.left - kMargin.right);
  const toY = scale(rangeY, kHeight - kMargin.bottom, kMargin.top + kMargin.bottom - kHeight);
  const picture = piece("svg", { viewBox: `0 0 ${kWidth} ${kHeight}`, role: "img", "aria-label": title });
  const paths = lines.map((line) => piece("path", { d: pathOf(line, toX, toY), class: "curve" }));
  picture.append(...axes(across, up, rangeX, rangeY, toX, toY), ...paths);
  const figure = document.createElement("figure");
  figure.className = "diagram";
  figure.append(Object.assign(document.createElement("figcaption"), { textContent: title }), picture);
  const list = legend(curves);
  if (curves.length > 1) figure.append(list);
  function paint() {
    paths.forEach((path, i) => path.setAttribute("stroke", curveColour(i)));
    list.querySelectorAll("i").forEach((swatch, i) => { swatch.style.background = curveColour(i); });
  }
  paint();
  onThemeChange(paint);
  return figure;
}
