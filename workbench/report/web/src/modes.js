// The list of modes: chooses what is animated, how large and whether damped.

import { shortNumber } from "./numbers.js";
import { createPlane } from "./plane.js";
import { pace, setDamped } from "./swing.js";

const kRounding = 1e-9;

const at = (id) => document.getElementById(id);

function cell(row, text, isNumber) {
  const element = row.insertCell();
  element.textContent = text;
  if (isNumber) element.className = "number";
  return element;
}

/** A value beside another that it belongs to: what is rounding of that counts as nothing. */
function cleaned(value, size) {
  return Math.abs(value) < kRounding * size ? 0 : value;
}

const listed = (value, digits = 4) => shortNumber(value, digits);

function eigenvalueText({ eigenvalue: [real, imaginary], oscillates, neutral }) {
  if (neutral) return "0";
  return oscillates ? `${listed(cleaned(real, imaginary))} \u00b1 ${listed(imaginary)} i` : listed(real);
}

/** A row of the list, with the button that chooses it. */
function addRow(body, mode, index) {
  const row = body.insertRow();
  const button = Object.assign(document.createElement("input"), { type: "radio", name: "mode", value: String(index) });
  const label = document.createElement("label");
  label.append(button, String(index + 1));
  cell(row, "").append(label);
  cell(row, mode.oscillates ? listed(mode.frequency) : "", true);
  cell(row, mode.oscillates ? listed(cleaned(mode.damping_ratio, 1)) : "", true);
  cell(row, mode.oscillates || mode.neutral ? "" : listed(1 / Math.abs(mode.eigenvalue[0]), 3), true);
  const value = document.createElement(mode.unstable ? "b" : "span");
  value.textContent = eigenvalueText(mode);
  value.classList.toggle("unstable", mode.unstable);
  cell(row, "", true).append(value);
  cell(row, mode.name).title = mode.name;
  return { row, button };
}

function paceText(speed) {
  if (speed === 1) return "real time";
  return speed < 1 ? `${shortNumber(1 / speed)} times slower than real` : `${shortNumber(speed)} times faster than real`;
}

/** Ties the list to the player and the view. */
export function createModes(modes, player, view) {
  const rows = modes.map((mode, index) => addRow(at("mode-rows"), mode, index));
  const amplitude = at("amplitude");
  let chosen = 0;

  function showSwing() {
    const mode = modes[chosen];
    mode.amplitude = Number(amplitude.value);
    at("moved").textContent = mode.motion > kRounding
      ? `up to ${shortNumber(mode.amplitude * mode.motion, 2)} m` : "bodies turn";
    view?.showAnimation(mode);
  }

  function begin() {
    const mode = modes[chosen];
    setDamped(mode, at("damped").checked);
    at("damped").disabled = !mode.oscillates;
    player.setRange(mode.start, mode.end);
  }

  function choose(index) {
    if (index < 0 || index >= modes.length) return;
    chosen = index;
    rows.forEach(({ row }, i) => row.classList.toggle("chosen", i === index));
    const { button } = rows[index];
    button.checked = true;
    if (document.activeElement?.name === "mode") button.focus();
    button.scrollIntoView({ block: "nearest" });
    plane.mark(index);
    at("shape").textContent = `${modes[index].unstable ? "Unstable. " : ""}Moves most: ${modes[index].name || "nothing"}`;
    begin();
    showSwing();
    player.setSpeed(pace(modes[index]));
  }

  const plane = createPlane(modes, at("plane"), choose);
  rows.forEach(({ row }, index) => row.addEventListener("click", () => choose(index)));
  amplitude.addEventListener("input", showSwing);
  at("damped").addEventListener("change", begin);
  player.listen(({ speed }) => {
    at("pace").textContent = paceText(speed);
  });
  choose(0);
  return { choose, chosen: () => chosen };
}
