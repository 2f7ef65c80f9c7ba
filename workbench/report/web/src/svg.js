// Pieces of pictures that the page draws as SVG.

import { niceStep } from "./numbers.js";

export function piece(name, attributes, text) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  Object.entries(attributes).forEach(([key, value]) => element.setAttribute(key, value));
  if (text !== undefined) element.textContent = text;
  return element;
}

/** Round places on an axis, about `count` of them. */
export function ticks(from, to, count = 4) {
  const step = niceStep((to - from) / count);
  const places = [];
  for (let i = Math.ceil(from / step); i * step <= to; ++i) places.push(i * step);
  return places;
}
