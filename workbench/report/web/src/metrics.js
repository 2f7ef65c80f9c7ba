// The numbers that a standard defines for a manoeuvre, and its diagrams, before the plots.

import { createDiagram } from "./diagram.js";
import { inDegrees, shortNumber } from "./numbers.js";

const listed = (value) => (Array.isArray(value) ? value : []);
const words = (name) => name.replaceAll("_", " ");
const titled = (text) => text.charAt(0).toUpperCase() + text.slice(1);

function element(name, textContent, className = "") {
  return Object.assign(document.createElement(name), { textContent, className });
}

function row({ name, value, unit, meaning }) {
  const { factor, unit: as } = inDegrees(unit);
  const result = document.createElement("tr");
  const head = Object.assign(element("th", words(name)), { scope: "row" });
  head.append(element("small", meaning));
  result.append(head, element("td", shortNumber(factor * value, 4), "number"), element("td", as === "1" ? "" : as));
  return result;
}

/** Writes the metrics of a run into an element. Nothing where the run was no manoeuvre. */
export function writeMetrics(run, target) {
  const [metrics, notes, diagrams] = [run?.metrics, run?.metric_notes, run?.diagrams].map(listed);
  if (metrics.length + notes.length === 0) return;
  const manoeuvre = run.manoeuvre ?? {};
  const box = document.createElement("details");
  box.id = "metrics";
  box.open = true;
  const summary = element("summary", manoeuvre.title ?? titled(words(manoeuvre.type ?? "manoeuvre")));
  if (manoeuvre.file) summary.append(element("small", manoeuvre.file));
  const table = document.createElement("table");
  table.createTBody().append(...metrics.map(row));
  box.append(summary, table, ...notes.map((note) => element("p", note, "hint")));
  box.append(...diagrams.map(createDiagram));
  target.append(box);
}
