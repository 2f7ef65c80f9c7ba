// The tables of the page: model, run, outputs, loop blocks.

function number(value) {
  if (value === null || value === undefined) return "";
  if (typeof value !== "number") return String(value);
  if (Number.isInteger(value) && Math.abs(value) < 1e6) return String(value);
  const size = Math.abs(value);
  return size < 1e-3 || size >= 1e6 ? value.toExponential(2) : Number(value.toPrecision(5)).toString();
}

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
      cell.textContent = number(value);
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
    ["rods", model.rods], ["springs and dampers", model.springs], ["tyres", model.tyres],
    ["relative coordinates", model.coordinates], ["loop equations", model.equations],
    ["of which independent", model.independent_equations], ["degrees of freedom", model.degrees_of_freedom],
    ["of which driven", model.driven],
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
    ["relative error of energy", run.relative_energy_error],
  ];
}

export function writeSummary(data, element) {
  const { model, run } = data;
  const times = data.table.times;
  const result = { name: data.result, rows: data.table.all_rows, start: times[0], end: times[data.table.rows - 1] };
  const outputs = data.table.columns.filter((column) => column.group === "output");
  element.append(table("Model", [], modelRows(model)), table("Run", [], runRows(run, result)));
  if (outputs.length > 0) {
    element.append(table("Outputs", ["", "unit", "smallest", "largest", "last"],
      outputs.map((column) => [column.name, column.unit, column.smallest, column.largest, column.last])));
  }
  if (model.blocks.length > 0) {
    element.append(table("Loop blocks", ["", "on", "coordinates", "equations", "rank", "closed by", "independent"],
      model.blocks.map((block, b) => [`block ${b + 1}`, block.base, block.coordinates, block.equations, block.rank,
        block.loops.join(", "), block.independent.join(", ")])));
  }
}
