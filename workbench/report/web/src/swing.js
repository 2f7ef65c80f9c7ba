// A mode in motion: where its swing is at a time, how fast it is shown, and where the bodies are.

import { kPose, niceStep } from "./numbers.js";

const kNeutralPeriod = 4; // s, of a mode that has no time of its own
const kTimeConstants = 4; // that are shown of a mode that does not oscillate
const kSmallest = 0.02; // part of a damped swing that is not shown any more
const kMostPeriods = 20;
const kShortest = 0.5; // s that a period lasts at least as it is shown
const kLongest = 5;

/** Rate of growth, 1/s: below zero for what decays. */
const growth = (mode) => (mode.neutral ? 0 : mode.eigenvalue[0]);

/** Time of a mode until it begins anew, s: a period, or until nothing is left. */
function duration(mode) {
  if (mode.neutral) return kNeutralPeriod;
  const rate = Math.abs(growth(mode));
  if (!mode.oscillates) return kTimeConstants / rate;
  const periods = mode.isDamped && rate > 0 ? Math.ceil(-Math.log(kSmallest) / rate * mode.frequency) : 1;
  return Math.min(kMostPeriods, periods) / mode.frequency;
}

/** Whether a mode decays or grows while it is shown; what does not oscillate always does. */
export function setDamped(mode, isDamped) {
  mode.isDamped = isDamped || !mode.oscillates;
  mode.end = duration(mode);
}

/** A mode as an animation, at half of its largest swing. Its time begins with the swing. */
export function createSwing(animation, rest) {
  const mode = { ...animation, rest, amplitude: 0.5, start: 0 };
  setDamped(mode, false);
  return mode;
}

/** Seconds of the mode a second of the player: 1 where that can be seen, else 1, 2 or 5 times a power of ten. */
export function pace(mode) {
  const time = mode.neutral ? kNeutralPeriod : mode.oscillates ? 1 / mode.frequency : 2 / Math.abs(growth(mode));
  if (time < kShortest) return niceStep(time / kShortest);
  return time > kLongest ? 1 / niceStep(kLongest / time) : 1;
}

/** Phase of a swing: turns since it began and its size, 1 for all of it. A growing mode ends at its full size. */
function courseAt(mode, time) {
  if (mode.neutral) return { turns: 0, size: Math.sin((2 * Math.PI * time) / kNeutralPeriod) };
  const rate = growth(mode);
  const size = mode.isDamped ? Math.exp(rate * (rate > 0 ? time - mode.end : time)) : 1;
  return { turns: mode.oscillates ? time * mode.frequency : 0, size };
}

/** The curve of order four through the ends of the swing, of half of it, and the point: loops stay closed along it. */
function through(part, rest, half, all) {
  const odd = ([before, after]) => (after - before) / 2;
  const even = ([before, after]) => (after + before) / 2 - rest;
  const third = (4 / 3) * (odd(all) - 2 * odd(half));
  const fourth = (4 / 3) * (even(all) - 4 * even(half));
  return rest + part * (odd(all) - third + part * (even(all) - fourth + part * (third + part * fourth)));
}

const numbers = new Float32Array(kPose);

/** Puts bodies where a mode has them at a time; null: at the point itself. */
export function poseSwing(bodies, mode, time) {
  const { turns, size } = time === null ? { turns: 0, size: 0 } : courseAt(mode, time);
  const part = size * mode.amplitude;
  const place = (turns - Math.floor(turns)) * mode.count;
  const ahead = place - Math.floor(place);
  const frame = (steps) => ((Math.floor(place) + steps) % mode.count) * bodies.length * kPose;
  const frames = [frame(0), frame(1), frame(mode.count / 2), frame(mode.count / 2 + 1)];
  const whole = mode.count * bodies.length * kPose; // frames of all of the swing stand behind those of half of it
  const between = (from, to) => mode.poses[from] + ahead * (mode.poses[to] - mode.poses[from]);
  bodies.forEach((group, body) => {
    for (let i = 0; i < kPose; ++i) {
      const k = body * kPose + i;
      const [now, next, opposite, afterOpposite] = frames.map((start) => start + k);
      numbers[i] = through(part, mode.rest[k], [between(opposite, afterOpposite), between(now, next)],
        [between(whole + opposite, whole + afterOpposite), between(whole + now, whole + next)]);
    }
    group.position.fromArray(numbers);
    group.quaternion.fromArray(numbers, 3).normalize();
  });
}
