// The tables of the page: model, run or point, outputs, loop blocks.

import { shortNumber } from "./numbers.js";

function table(caption, heads, rows) {
  const element = document.createElement("table");
  element.createCaption().textContent = caption;
  if (heads.length > 0) {
    const row = element.createTHead().insertRow();
    heads.forEach((head) => row.append(Object.assign(document.createElement("th"), { textContent: head, scope: "col" })));
  }
  const body = element.createTBody();
  rows.forEach(([first, ...others]) => {
    const row = body.insertRow();
    row.append(Object.assign(document.createElement("th"), { textContent: first, scope: "row" }));
    others.forEach((value) => {
      const cell = row.insertCell();
      cell.textContent = shortNumber(value);
      if (typeof value === "number") cell.className = "number";
    });
  });
  const frame = document.createElement("div");
  frame.className = "table";
  frame.append(element);
  return frame;
}

function modelRows(model) {
  return [
    ["file", model.file], ["hash", model.hash], ["bodies with ground", model.bodies], ["joints", model.joints],
    ["rods", model.rods], ...model.elements,
    ["relative coordinates", model.coordinates], ["loop equations", model.equations],
    ["of which independent", model.independent_equations],
    ...(model.position_freedoms === model.degrees_of_freedom ? [] : [["freedoms of positions", model.position_freedoms]]),
    ["degrees of freedom", model.degrees_of_freedom], ["of which driven", model.driven],
  ];
}

function runRows(run, result) {
  if (!run) return [["table", result.name], ["rows", result.rows], ["from, s", result.start], ["to, s", result.end]];
  return [
    ["table", result.name], ["rows", run.rows], ["engine", run.engine], ["integrator", run.integrator],
    ["stabilisation", run.stabilisation], ["steps", run.steps], ["step, s", run.step], ["end, s", run.end_time],
    ["status", run.status], ["largest closure residual, m", run.position_residual],
    ["the same of velocities, m/s", run.velocity_residual], ["change of energy, J", run.energy_change],
    ["work of forces and drives, J", run.work], ["error of energy, J", run.energy_error],
    ["relative error of energy", run.relative_energy_error ?? "none: nothing was exchanged"],
  ];
}

function resultTables(data) {
  const { times, columns, rows, all_rows } = data.table;
  const result = { name: data.result, rows: all_rows, start: times[0], end: times[rows - 1] };
  const outputs = columns.filter((column) => column.group === "output");
  const tables = [table("Run", [], runRows(data.run, result))];
  const moved = data.run?.moved_start ?? [];
  if (moved.length > 0) {
    tables.push(table("Initial values that moved to close the loops", ["", "quantity", "asked", "found"],
      moved.map((value) => [value.coordinate, value.quantity, value.asked, value.found])));
  }
  if (outputs.length > 0) {
    tables.push(table("Outputs", ["", "unit", "smallest", "largest", "last"],
      outputs.map((column) => [column.name, column.unit, column.smallest, column.largest, column.last])));
  }
  return tables;
}

function pointTable({ state, drift }) {
  return table("Point", [], [["modes about", state], ["largest rate of the states there, per s", drift]]);
}

/** List of simplifications that the page makes. */
function noteList(notes) {
  const list = Object.assign(document.createElement("ul"), { id: "notes" });
  list.append(...notes.map((textContent) => Object.assign(document.createElement("li"), { textContent })));
  return list;
}

export function writeSummary(data, element) {
  const { model } = data;
  if (data.notes) element.before(noteList(data.notes));
  element.append(table("Model", [], modelRows(model)), ...(data.table ? resultTables(data) : [pointTable(data.point)]));
  if (model.blocks.length > 0) {
    element.append(table("Loop blocks", ["", "on", "coordinates", "equations", "rank", "closed by", "independent"],
      model.blocks.map((block, b) => [`block ${b + 1}`, block.base, block.coordinates, block.equations, block.rank,
        block.loops.join(", "), block.independent.join(", ")])));
  }
}
