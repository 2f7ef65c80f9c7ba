// The page of mbgen: animation, tables and topology, with the plots of a result or the list of a model's modes.

import { readData } from "./data.js";
import { writeMetrics } from "./metrics.js";
import { createModes } from "./modes.js";
import { createPicker } from "./picker.js";
import { createPlayer } from "./player.js";
import { createPlots, firstPlots } from "./plots.js";
import { writeResponses } from "./responses.js";
import { writeSummary } from "./summary.js";
import { createView } from "./view.js";
import { kLayers } from "./world.js";
import { cameraNames } from "./camera.js";

const kSpeeds = [0.05, 0.1, 0.25, 0.5, 1, 2, 4];
const kModeSpeeds = [-4, -3, -2, -1, 0, 1, 2, 3].flatMap((power) => [1, 2, 5].map((digit) => Number(`${digit}e${power}`)));
const kFrame = 1 / 60; // s, of a step by key at normal speed

const at = (id) => document.getElementById(id);

function option(value, text) {
  return Object.assign(document.createElement("option"), { value, textContent: text });
}

/** The animation, or null with a word why there is none. */
function tryView(data) {
  try {
    return createView(data.scene, data.animations[0], at("view"), data.table, data.others);
  } catch (problem) {
    at("tip").hidden = false;
    at("tip").textContent = `No animation: this browser gives no WebGL (${problem.message}). All else is complete.`;
    return null;
  }
}

function writeHeader(data) {
  const { model } = data;
  at("name").textContent = model.name;
  at("facts").textContent = `${model.degrees_of_freedom - model.driven} free and ${model.driven} driven degrees of freedom, ${model.coordinates} coordinates, ${model.equations} loop equations`;
  const others = data.others ?? [];
  if (others.length > 0) at("facts").textContent += `; ${data.label}, translucent: ${others.map(({ label }) => label).join("; ")}`;
  if (data.point) at("facts").textContent += `; modes about its ${data.point.state}`;
}

function connectControls(player, view, data, speeds) {
  const { state } = player;
  const scrub = at("scrub");
  at("play").addEventListener("click", player.toggle);
  at("start").addEventListener("click", () => player.seek(state.start));
  scrub.addEventListener("input", () => {
    const wanted = Number(scrub.value); // pausing moves the slider to the time that is shown
    player.pause();
    player.seek(wanted);
  });
  speeds.forEach((speed) => at("speed").append(option(speed, `${speed} x`)));
  at("speed").addEventListener("change", () => player.setSpeed(Number(at("speed").value)));
  cameraNames(data.scene).forEach((name) => at("camera").append(option(name, name)));
  at("camera").addEventListener("change", () => view?.chooseCamera(at("camera").value));
  if (data.scene.follow < 0) at("followed").append(option(-1, "the whole model"));
  data.scene.bodies.forEach((body, i) => body.shapes.length > 0 && at("followed").append(option(i, body.name)));
  at("followed").value = String(data.scene.follow);
  at("followed").addEventListener("change", () => view?.followBody(Number(at("followed").value)));
  Object.entries(kLayers).forEach(([name, isShown]) => {
    if (!view?.hasLayer(name)) return;
    const box = Object.assign(document.createElement("input"), { type: "checkbox", checked: isShown, name });
    box.addEventListener("change", () => view.setLayer(name, box.checked));
    const label = document.createElement("label");
    label.append(box, name);
    at("layers").append(label);
  });
  if (view) listBodies(view, data.scene.bodies);
}

/** A box for each body that is drawn, to show and hide it alone. */
function listBodies(view, bodies) {
  const list = document.createElement("div");
  bodies.forEach(({ name, shapes }, index) => {
    if (shapes.length === 0) return;
    const box = Object.assign(document.createElement("input"), { type: "checkbox", checked: true, name: `body ${name}` });
    box.addEventListener("change", () => view.showBody(index, box.checked));
    const label = document.createElement("label");
    label.append(box, name);
    list.append(label);
  });
  const details = document.createElement("details");
  details.append(Object.assign(document.createElement("summary"), { textContent: "single bodies" }), list);
  at("layers").append(details);
}

function showState(player, view) {
  const { state } = player;
  const scrub = at("scrub");
  function show() {
    scrub.min = String(state.start);
    scrub.max = String(state.end);
    scrub.value = String(state.time);
    // A hundredth of what is shown, and of a second.
    const digits = Math.max(2, 2 - Math.floor(Math.log10(state.end - state.start || 1)));
    scrub.setAttribute("aria-valuetext", `${state.time.toFixed(digits)} seconds`);
    at("clock").textContent = `${state.time.toFixed(digits)} / ${state.end.toFixed(digits)} s`;
    at("speed").value = String(state.speed);
    at("play").classList.toggle("playing", state.playing);
    at("play").setAttribute("aria-label", state.playing ? "pause" : "play");
    view?.show(state.time);
  }
  player.listen(show);
  show();
}

/** Whether what has the focus needs a key for itself; the keys of time and modes are the page's. */
function usesKey(element, key) {
  const control = element.closest("button, select, input, a, summary");
  if (!control || control === at("scrub") || control.name === "mode") return false;
  const isPressed = control.matches("button, a, summary, input[type=checkbox]");
  return !isPressed || key === " " || key === "Enter";
}

/** A clicked control gives the keys back to the page; a control reached by Tab keeps the focus. */
function returnKeys() {
  let byPointer = false;
  document.addEventListener("pointerdown", () => { byPointer = true; }, true);
  document.addEventListener("keydown", () => { byPointer = false; }, true);
  const release = (event) => {
    const control = event.target.closest("button, select, summary, input[type=checkbox], input[type=range]");
    if (byPointer && control && !control.closest("dialog")) control.blur();
  };
  document.addEventListener("change", release);
  document.addEventListener("click", (event) => event.target.closest("select, input[type=range]") || release(event));
}

/** others: actions of further keys. */
function connectKeys(player, view, data, speeds, others) {
  const { state } = player;
  const names = cameraNames(data.scene);
  function changeSpeed(by) {
    const place = speeds.indexOf(state.speed) + by;
    if (place >= 0 && place < speeds.length) player.setSpeed(speeds[place]);
  }
  function step(frames) {
    player.pause();
    player.seek(state.time + frames * kFrame * state.speed);
  }
  function chooseCamera(place) {
    if (place >= names.length) return;
    at("camera").value = names[place];
    view?.chooseCamera(names[place]);
  }
  const actions = {
    " ": player.toggle,
    Home: () => player.seek(state.start),
    End: () => player.seek(state.end),
    ArrowLeft: (event) => step(event.shiftKey ? -10 : -1),
    ArrowRight: (event) => step(event.shiftKey ? 10 : 1),
    "+": () => changeSpeed(1),
    "-": () => changeSpeed(-1),
    a: () => view?.orbit(-1, 0, 0),
    d: () => view?.orbit(1, 0, 0),
    w: () => view?.orbit(0, 1, 0),
    s: () => view?.orbit(0, -1, 0),
    e: () => view?.orbit(0, 0, 1),
    q: () => view?.orbit(0, 0, -1),
    ...others,
  };
  [0, 1, 2, 3].forEach((place) => {
    actions[place + 1] = () => chooseCamera(place);
  });
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || at("picker").open) return;
    const action = actions[event.key];
    if (!action || usesKey(event.target, event.key)) return;
    event.preventDefault();
    action(event);
  });
}

function startPlots(data, player) {
  writeMetrics(data.run, at("charts"), data.label, data.others);
  const pick = createPicker(data.table);
  const plots = createPlots(data.table, player, at("charts"), pick);
  firstPlots(data.table).forEach(plots.add);
  at("add-plot").addEventListener("click", () => pick([], plots.add));
  at("reset-zoom").addEventListener("click", plots.resetZoom);
  return plots;
}

/** The modes, the first of them moving; and the keys that choose one. */
function startModes(data, player, view) {
  const modes = createModes(data.animations, player, view);
  if (!window.matchMedia("(prefers-reduced-motion: reduce)").matches) player.play();
  const keys = {
    ArrowUp: () => modes.choose(modes.chosen() - 1),
    ArrowDown: () => modes.choose(modes.chosen() + 1),
  };
  return { modes, keys };
}

function start() {
  const data = readData();
  const isResult = Boolean(data.table);
  const speeds = isResult ? kSpeeds : kModeSpeeds;
  const player = createPlayer(data.animations[0], !isResult);
  at("plots").hidden = !isResult;
  at("modes").hidden = isResult;
  at("mode-keys").hidden = isResult;
  writeHeader(data);
  const view = tryView(data);
  connectControls(player, view, data, speeds);
  showState(player, view);
  const plots = isResult ? startPlots(data, player) : null;
  const { modes, keys } = isResult ? { modes: null, keys: {} } : startModes(data, player, view);
  connectKeys(player, view, data, speeds, keys);
  returnKeys();
  writeResponses(data.responses, at("responses"), at("response-diagrams"));
  at("to-responses").hidden = at("responses").hidden;
  writeSummary(data, at("tables"));
  at("drawing").innerHTML = data.topology; // SVG that mbgen drew, names escaped
  function frame(now) {
    player.advance(now);
    view?.draw();
    requestAnimationFrame(frame);
  }
  requestAnimationFrame(frame);
  window.mbgenReport = { player, view, plots, modes, data }; // for tests
}

start();
