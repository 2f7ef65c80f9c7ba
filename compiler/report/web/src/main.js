// The page of mbgen report: animation, plots, tables and topology of one result.

import { readData } from "./data.js";
import { createPicker } from "./picker.js";
import { createPlayer } from "./player.js";
import { createPlots, firstPlots } from "./plots.js";
import { writeSummary } from "./summary.js";
import { createView } from "./view.js";
import { kLayers } from "./world.js";
import { cameraNames } from "./camera.js";

const kSpeeds = [0.05, 0.1, 0.25, 0.5, 1, 2, 4];
const kFrame = 1 / 60; // s, of a step by key at normal speed

const at = (id) => document.getElementById(id);

function option(value, text) {
  return Object.assign(document.createElement("option"), { value, textContent: text });
}

/** The animation, or null with a word why there is none. */
function tryView(data) {
  try {
    return createView(data.scene, data.animations[0], at("view"));
  } catch (problem) {
    at("tip").hidden = false;
    at("tip").textContent = `No animation: this browser gives no WebGL (${problem.message}). Plots and tables are complete.`;
    return null;
  }
}

function writeHeader(data) {
  const { model } = data;
  at("name").textContent = model.name;
  at("facts").textContent = `${model.degrees_of_freedom - model.driven} free and ${model.driven} driven degrees of freedom, ${model.coordinates} coordinates, ${model.equations} loop equations`;
}

function connectControls(player, view, data) {
  const { state } = player;
  const scrub = at("scrub");
  at("play").addEventListener("click", player.toggle);
  at("start").addEventListener("click", () => player.seek(state.start));
  scrub.addEventListener("input", () => {
    const wanted = Number(scrub.value); // pausing moves the slider to the time that is shown
    player.pause();
    player.seek(wanted);
  });
  kSpeeds.forEach((speed) => at("speed").append(option(speed, `${speed} x`)));
  at("speed").value = "1";
  at("speed").addEventListener("change", () => player.setSpeed(Number(at("speed").value)));
  cameraNames(data.scene).forEach((name) => at("camera").append(option(name, name)));
  at("camera").addEventListener("change", () => view?.chooseCamera(at("camera").value));
  if (data.scene.follow < 0) at("followed").append(option(-1, "the whole model"));
  data.scene.bodies.forEach((body, i) => body.shapes.length > 0 && at("followed").append(option(i, body.name)));
  at("followed").value = String(data.scene.follow);
  at("followed").addEventListener("change", () => view?.followBody(Number(at("followed").value)));
  data.animations.forEach((animation, i) => at("animation").append(option(i, animation.name)));
  at("animation-choice").hidden = data.animations.length < 2;
  at("animation").addEventListener("change", () => {
    const animation = data.animations[Number(at("animation").value)];
    view?.showAnimation(animation);
    player.setRange(animation.start, animation.end);
  });
  Object.entries(kLayers).forEach(([name, isShown]) => {
    if (!view?.hasLayer(name)) return;
    const box = Object.assign(document.createElement("input"), { type: "checkbox", checked: isShown, name });
    box.addEventListener("change", () => view.setLayer(name, box.checked));
    const label = document.createElement("label");
    label.append(box, name);
    at("layers").append(label);
  });
}

function showState(player, view) {
  const { state } = player;
  const scrub = at("scrub");
  function show() {
    scrub.min = String(state.start);
    scrub.max = String(state.end);
    scrub.value = String(state.time);
    scrub.setAttribute("aria-valuetext", `${state.time.toFixed(2)} seconds`);
    at("clock").textContent = `${state.time.toFixed(2)} / ${state.end.toFixed(2)} s`;
    at("play").classList.toggle("playing", state.playing);
    at("play").setAttribute("aria-label", state.playing ? "pause" : "play");
    view?.show(state.time);
  }
  player.listen(show);
  show();
}

function connectKeys(player, view, data) {
  const { state } = player;
  const names = cameraNames(data.scene);
  function changeSpeed(by) {
    const place = kSpeeds.indexOf(state.speed) + by;
    if (place < 0 || place >= kSpeeds.length) return;
    at("speed").value = String(kSpeeds[place]);
    player.setSpeed(kSpeeds[place]);
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
  };
  [0, 1, 2, 3].forEach((place) => {
    actions[place + 1] = () => chooseCamera(place);
  });
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || at("picker").open) return;
    // Buttons, lists and fields keep the keys that they use themselves; the slider's are ours.
    const isControl = event.target.closest("button, select, input, a, summary") && event.target !== at("scrub");
    const action = actions[event.key];
    if (!action || isControl) return;
    event.preventDefault();
    action(event);
  });
}

function start() {
  const data = readData();
  const { start: from, end } = data.animations[0];
  const player = createPlayer(from, end);
  writeHeader(data);
  const view = tryView(data);
  connectControls(player, view, data);
  showState(player, view);
  connectKeys(player, view, data);
  const pick = createPicker(data.table);
  const plots = createPlots(data.table, player, at("charts"), pick);
  firstPlots(data.table).forEach(plots.add);
  at("add-plot").addEventListener("click", () => pick([], plots.add));
  at("reset-zoom").addEventListener("click", plots.resetZoom);
  writeSummary(data, at("tables"));
  at("drawing").innerHTML = data.topology; // SVG that mbgen drew, names escaped
  function frame(now) {
    player.advance(now);
    view?.draw();
    requestAnimationFrame(frame);
  }
  requestAnimationFrame(frame);
  window.mbgenReport = { player, view, plots }; // for tests
}

start();
