// A diagram of curves over a quantity that is not time.

import { inDegrees, shortNumber } from "./numbers.js";
import { piece, ticks } from "./svg.js";
import { curveColour, onThemeChange } from "./theme.js";

const kWidth = 460;
const kHeight = 210;
const kMargin = { left: 46, right: 12, top: 18, bottom: 34 };
const kRoom = 0.04; // of the range, beyond its ends

/** A heading with its values' factor, from SI units; asIs: with the unit that it has. */
function shown({ name, unit }, asIs) {
  const { factor, unit: as } = asIs ? { factor: 1, unit } : inDegrees(unit);
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

/** Places and words of an axis; of a logarithmic one 1, 2 and 5 times the powers of ten, of many decades these alone. */
function marks([from, to], isLogarithmic, count) {
  if (!isLogarithmic) return ticks(from, to, count).map((at) => ({ at, text: shortNumber(at) }));
  const digits = to - from > 2.5 ? [1] : [1, 2, 5];
  const places = [];
  for (let power = Math.floor(from); power <= to; ++power)
    digits.forEach((digit) => places.push({ at: power + Math.log10(digit), text: shortNumber(Number(`${digit}e${power}`)) }));
  const seen = places.filter(({ at }) => at >= from && at <= to);
  const stride = Math.ceil(seen.length / (2 * (count ?? 4)));
  return seen.filter((mark, i) => i % stride === 0);
}

function axes(across, up, rangeX, rangeY, toX, toY, logarithmic) {
  const right = kWidth - kMargin.right;
  const bottom = kHeight - kMargin.bottom;
  const line = (x1, y1, x2, y2, value) => piece("line", { x1, y1, x2, y2, class: value === 0 ? "axis" : "grid" });
  return [
    ...marks(rangeX, logarithmic.x, 6).flatMap(({ at, text }) => [
      line(toX(at), kMargin.top, toX(at), bottom, logarithmic.x ? null : at),
      piece("text", { x: toX(at), y: bottom + 13, "text-anchor": "middle" }, text),
    ]),
    ...marks(rangeY, logarithmic.y).flatMap(({ at, text }) => [
      line(kMargin.left, toY(at), right, toY(at), logarithmic.y ? null : at),
      piece("text", { x: kMargin.left - 4, y: toY(at) + 3, "text-anchor": "end" }, text),
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

/** Values as they are drawn: without a logarithm there is nothing. */
function scaled(values, factor, isLogarithmic) {
  return values.map((value) => {
    if (value === null || (isLogarithmic && !(value > 0))) return null;
    return isLogarithmic ? Math.log10(factor * value) : factor * value;
  });
}

/** A figure of a diagram of the data: title, headings x and y, curves, some with a dash; logarithmic: "", "x" or "xy";
 * asIs: units as they are. */
export function createDiagram({ title, x, y, curves, logarithmic: axesNamed = "", asIs = false }) {
  const logarithmic = { x: axesNamed.includes("x"), y: axesNamed.includes("y") };
  const [across, up] = [shown(x, asIs), shown(y, asIs)];
  const lines = curves.map((curve) => ({
    x: scaled(curve.x, across.factor, logarithmic.x),
    y: scaled(curve.y, up.factor, logarithmic.y),
  }));
  const rangeX = limits(lines.flatMap((line) => line.x));
  const rangeY = limits(lines.flatMap((line) => line.y));
  const toX = scale(rangeX, kMargin.left, kWidth - kMargin.left - kMargin.right);
  const toY = scale(rangeY, kHeight - kMargin.bottom, kMargin.top + kMargin.bottom - kHeight);
  const picture = piece("svg", { viewBox: `0 0 ${kWidth} ${kHeight}`, role: "img", "aria-label": title });
  const paths = lines.map((line, i) => piece("path", {
    d: pathOf(line, toX, toY), class: "curve", "stroke-dasharray": curves[i].dash ?? "none",
  }));
  picture.append(...axes(across, up, rangeX, rangeY, toX, toY, logarithmic), ...paths);
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
