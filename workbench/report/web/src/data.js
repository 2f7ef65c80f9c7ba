// The data of the page as mbgen wrote them (workbench/report): JSON, its long lists as 32-bit numbers in base64.

import { courseOf } from "./course.js";
import { kPose } from "./numbers.js";
import { createSwing } from "./swing.js";

function floats(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  return new Float32Array(bytes.buffer);
}

/** Poses of all bodies at any time between its first and last frame. */
function decodeAnimation(animation, bodyCount) {
  const times = floats(animation.times);
  const poses = floats(animation.poses);
  return { ...animation, times, poses, bodyCount, start: times[0], end: times[times.length - 1] };
}

const kNoise = 1e-9; // of the largest value of its unit: smaller motions of a column are rounding
const kLeastNoise = 1e-10; // in SI units
const kRounding = 2.4e-7; // of the column's largest value: what its 32 bits do not tell apart

/** Sizes below which a value is rounding, by unit. The closure residual is small and meant. */
function noiseOf(columns) {
  const largest = new Map();
  columns.forEach(({ unit, smallest, largest: most }) => {
    largest.set(unit, Math.max(largest.get(unit) ?? 0, Math.abs(smallest), Math.abs(most)));
  });
  return ({ unit, group, smallest, largest: most }) => {
    const rounding = kRounding * Math.max(Math.abs(smallest), Math.abs(most));
    return group === "residual" ? 0 : Math.max(kLeastNoise, kNoise * largest.get(unit), rounding);
  };
}

/** Strips of roads and tracks of wheels with their numbers. */
function decodeGround(ground) {
  const numbers = ({ stations, offsets, heights, friction, ...others }) => ({
    ...others,
    stations: floats(stations),
    offsets: floats(offsets),
    heights: floats(heights),
    friction: friction && floats(friction),
  });
  return {
    floor: ground.floor,
    strips: ground.strips.map(numbers),
    tracks: ground.tracks.map((track) => ({ ...track, heights: floats(track.heights) })),
  };
}

/** Columns with their values and the size of their rounding. */
function decodeTable(table) {
  const data = floats(table.data);
  const noise = noiseOf(table.columns);
  const columns = table.columns.map((column, c) => ({
    ...column,
    noise: noise(column),
    values: data.subarray(c * table.rows, (c + 1) * table.rows), // NaN of another result that has ended
  }));
  return { ...table, columns, times: columns[0].values };
}

/** Reads the page's data: model, scene, animations, topology, and of a result run, table and other results, of modes point,
 * rest and frequency responses. */
export function readData() {
  const data = JSON.parse(document.getElementById("data").textContent);
  if (data.scene.ground) data.scene.ground = decodeGround(data.scene.ground);
  if (data.table) {
    data.animations = data.animations.map((animation) => decodeAnimation(animation, data.scene.bodies.length));
    data.table = decodeTable(data.table);
    data.scene.course = courseOf(data.run);
    data.others = (data.others ?? []).map((other) => (
      { ...other, animation: decodeAnimation(other.animation, other.scene.bodies.length) }));
  } else {
    const rest = floats(data.rest);
    data.animations = data.animations.map((mode) => createSwing({ ...mode, poses: floats(mode.poses) }, rest));
  }
  return data;
}

/** Index of the last of ascending times that is not after `time`, 0 when there is none. */
export function indexAt(times, time) {
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** Value of a column at a time, straight between rows. */
export function valueAt(times, values, time) {
  const i = indexAt(times, time);
  if (i + 1 >= times.length) return values[times.length - 1];
  const part = Math.min(1, Math.max(0, (time - times[i]) / (times[i + 1] - times[i])));
  return values[i] + part * (values[i + 1] - values[i]);
}

/** Where the numbers of a body's pose begin. */
export function poseOffset(animation, frame, body) {
  return (frame * animation.bodyCount + body) * kPose;
}

/** A body's origin at a time: [x, y, z]. */
export function originAt(animation, body, time) {
  const frame = indexAt(animation.times, time);
  const next = Math.min(frame + 1, animation.times.length - 1);
  const span = animation.times[next] - animation.times[frame];
  const part = span > 0 ? Math.min(1, Math.max(0, (time - animation.times[frame]) / span)) : 0;
  const a = poseOffset(animation, frame, body);
  const b = poseOffset(animation, next, body);
  return [0, 1, 2].map((i) => animation.poses[a + i] + part * (animation.poses[b + i] - animation.poses[a + i]));
}
