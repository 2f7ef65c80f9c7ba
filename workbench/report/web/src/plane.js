// Eigenvalues in their plane: real parts to the right, imaginary parts upwards.

import { shortNumber } from "./numbers.js";
import { piece, ticks } from "./svg.js";

const kWidth = 460;
const kHeight = 250;
const kMargin = { left: 14, right: 14, top: 14, bottom: 20 };
const kRoom = 1.12; // beyond the last eigenvalue
const kNarrowest = 0.3; // of the height, so that undamped modes do not make it a line

/** Range of the plane: all oscillations and all growing modes; without them all modes. Others stand at its edge. */
function limits(modes) {
  const wanted = modes.filter((mode) => mode.oscillates || mode.unstable);
  const shown = (wanted.length > 0 ? wanted : modes).map((mode) => mode.eigenvalue);
  const high = kRoom * Math.max(...shown.map(([, imaginary]) => Math.abs(imaginary)));
  const low = Math.min(0, ...shown.map(([real]) => kRoom * real));
  const right = Math.max(0, ...shown.map(([real]) => kRoom * real));
  const top = high || right - low || 1;
  const least = kNarrowest * top;
  return { top, left: Math.min(low, -least), right: Math.max(right, least / 3) };
}

function createScales(modes) {
  const { top, left, right } = limits(modes);
  const { left: x0, top: y0 } = kMargin;
  const width = kWidth - x0 - kMargin.right;
  const height = kHeight - y0 - kMargin.bottom;
  return {
    x: (real) => x0 + (width * (Math.min(right, Math.max(left, real)) - left)) / (right - left),
    y: (imaginary) => y0 + (height * (top - imaginary)) / (2 * top),
    isInside: (real) => real >= left && real <= right,
    ticksX: ticks(left, right),
    ticksY: ticks(-top, top),
  };
}

function axes(scales) {
  const right = kWidth - kMargin.right;
  const bottom = kHeight - kMargin.bottom;
  const line = (x1, y1, x2, y2, zero) => piece("line", { x1, y1, x2, y2, class: zero ? "axis" : "grid" });
  return [
    ...scales.ticksX.flatMap((real) => [
      line(scales.x(real), kMargin.top, scales.x(real), bottom, real === 0),
      piece("text", { x: scales.x(real), y: bottom + 13, "text-anchor": "middle" }, shortNumber(real)),
    ]),
    ...scales.ticksY.flatMap((imaginary) => [
      line(kMargin.left, scales.y(imaginary), right, scales.y(imaginary), imaginary === 0),
      imaginary === 0 ? [] : piece("text", { x: kMargin.left + 2, y: scales.y(imaginary) - 2 }, `${shortNumber(imaginary)} i`),
    ].flat()),
    piece("text", { x: right, y: kMargin.top - 4, "text-anchor": "end" }, "1/s"),
  ];
}

/** The marks of an eigenvalue and its conjugate; a triangle at the edge for what is further away. */
function marks(mode, scales) {
  const [real, imaginary] = mode.eigenvalue;
  const x = scales.x(real);
  return (mode.oscillates ? [imaginary, -imaginary] : [0]).map((height) => {
    const y = scales.y(height);
    const point = real < 0 ? -1 : 1;
    const mark = scales.isInside(real)
      ? piece("circle", { cx: x, cy: y, r: 4.5 })
      : piece("path", { d: `M${x + 6 * point} ${y}l${-9 * point} -5v10z` });
    mark.classList.toggle("unstable", mode.unstable);
    return mark;
  });
}

/** The plane in an element; choose(i) is told of clicks. */
export function createPlane(modes, element, choose) {
  const scales = createScales(modes);
  const picture = piece("svg", { viewBox: `0 0 ${kWidth} ${kHeight}`, role: "img", "aria-label": "eigenvalues in their plane" });
  picture.append(...axes(scales));
  const groups = modes.map((mode, i) => {
    const group = piece("g", { class: "eigenvalue" });
    group.append(piece("title", {}, `mode ${i + 1}`), ...marks(mode, scales));
    group.addEventListener("click", () => choose(i));
    return group;
  });
  picture.append(...groups);
  element.append(picture);
  return {
    /** Marks a mode, in front of the others. */
    mark(chosen) {
      groups.forEach((group, i) => group.classList.toggle("chosen", i === chosen));
      picture.append(groups[chosen]);
    },
  };
}
