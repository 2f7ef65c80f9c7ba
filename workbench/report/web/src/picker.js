// The dialog that chooses the columns of a plot.

const kGroups = { output: "Outputs", force: "Forces of elements", coordinate: "Coordinates", velocity: "Velocities", residual: "Closure" };

export function createPicker(table) {
  const dialog = document.getElementById("picker");
  const filter = document.getElementById("picker-filter");
  const list = document.getElementById("picker-list");
  let done = null;

  const boxes = table.columns.map((column, c) => {
    const label = document.createElement("label");
    const box = document.createElement("input");
    box.type = "checkbox";
    box.value = String(c);
    label.append(box, column.name, Object.assign(document.createElement("small"), { textContent: column.unit }));
    return { column, label, box };
  });
  Object.entries(kGroups).forEach(([group, title]) => {
    const own = boxes.filter(({ column }) => column.group === group);
    if (own.length === 0) return;
    const set = document.createElement("fieldset");
    set.append(Object.assign(document.createElement("legend"), { textContent: title }), ...own.map(({ label }) => label));
    list.append(set);
  });

  filter.addEventListener("input", () => {
    const wanted = filter.value.toLowerCase();
    boxes.forEach(({ column, label }) => {
      label.hidden = !column.name.toLowerCase().includes(wanted);
    });
  });
  // Enter in the filter shows the plot; the first button would cancel.
  filter.addEventListener("keydown", (event) => {
    if (event.key !== "Enter") return;
    event.preventDefault();
    dialog.close("show");
  });
  dialog.addEventListener("close", () => {
    const chosen = boxes.filter(({ box }) => box.checked).map(({ box }) => Number(box.value));
    if (dialog.returnValue === "show" && chosen.length > 0) done(chosen);
  });

  /** Opens with some columns chosen; tells those that were chosen in the end. */
  return function pick(columns, whenDone) {
    done = whenDone;
    dialog.returnValue = "";
    filter.value = "";
    boxes.forEach(({ box, label }) => {
      box.checked = columns.includes(Number(box.value));
      label.hidden = false;
    });
    dialog.showModal();
    filter.focus();
  };
}
