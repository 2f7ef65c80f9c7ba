// The numbers that a standard defines for a manoeuvre, and its diagrams, before the plots.

import { createDiagram } from "./diagram.js";
import { inDegrees, shortNumber } from "./numbers.js";

const listed = (value) => (Array.isArray(value) ? value : []);
const words = (name) => name.replaceAll("_", " ");
const titled = (text) => text.charAt(0).toUpperCase() + text.slice(1);

function element(name, textContent, className = "") {
  return Object.assign(document.createElement(name), { textContent, className });
}

/** others: metrics of other results, each with a value of its own. */
function row({ name, value, unit, meaning }, others) {
  const { factor, unit: as } = inDegrees(unit);
  const result = document.createElement("tr");
  const head = Object.assign(element("th", words(name)), { scope: "row" });
  head.append(element("small", meaning));
  const values = [value, ...others.map((metrics) => metrics.find((other) => other.name === name && other.unit === unit)?.value)];
  const cells = values.map((one) => element("td", Number.isFinite(one) ? shortNumber(factor * one, 4) : "", "number"));
  result.append(head, ...cells, element("td", as === "1" ? "" : as));
  return result;
}

/** A diagram with the curves of the same diagram of others; a curve that is the same in both stands once. */
function withOthers(diagram, others) {
  const own = listed(diagram.curves);
  const isKnown = (curve) => own.some(({ name, x, y }) => (
    name === curve.name && JSON.stringify([x, y]) === JSON.stringify([curve.x, curve.y])));
  const more = others.flatMap(({ label, run }) => (
    listed(run?.diagrams).filter(({ title }) => title === diagram.title).flatMap(({ curves }) => (
      listed(curves).filter((curve) => !isKnown(curve)).map((curve) => ({ ...curve, name: `${curve.name} (${label})`, dash: "6 3" }))))));
  return { ...diagram, curves: [...own, ...more] };
}

/** Which column is of which result. */
function labelRow(label, others) {
  const result = document.createElement("tr");
  result.append(document.createElement("th"), ...[label, ...others.map((other) => other.label)].map((text) => element("td", text)), element("td", ""));
  return result;
}

/** Writes the metrics of a run into an element, those of other runs beside them. Nothing where the run was no manoeuvre. */
export function writeMetrics(run, target, label = "", others = []) {
  const [metrics, notes, diagrams] = [run?.metrics, run?.metric_notes, run?.diagrams].map(listed);
  if (metrics.length + notes.length === 0) return;
  const manoeuvre = run.manoeuvre ?? {};
  const box = document.createElement("details");
  box.id = "metrics";
  box.open = true;
  const summary = element("summary", manoeuvre.title ?? titled(words(manoeuvre.type ?? "manoeuvre")));
  if (manoeuvre.file) summary.append(element("small", manoeuvre.file));
  const table = document.createElement("table");
  const beside = others.map((other) => listed(other.run?.metrics));
  if (others.length > 0) table.createTHead().append(labelRow(label, others));
  table.createTBody().append(...metrics.map((metric) => row(metric, beside)));
  box.append(summary, table, ...notes.map((note) => element("p", note, "hint")));
  box.append(...diagrams.map((diagram) => createDiagram(withOthers(diagram, others))));
  target.append(box);
}
