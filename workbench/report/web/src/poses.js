// Bodies at a time of an animation, between its frames.

import { Quaternion, Vector3 } from "three";
import { indexAt, poseOffset } from "./data.js";
import { poseSwing } from "./swing.js";

const before = new Vector3();
const after = new Vector3();
const turn = new Quaternion();
const turnAfter = new Quaternion();

/** Where the camera takes the bodies to be: it goes with a motion, and stands while a mode swings. */
export function poseForCamera(bodies, animation, time) {
  poseBodies(bodies, animation, animation.kind === "mode" ? null : time);
}

export function poseBodies(bodies, animation, time) {
  if (animation.kind === "mode") {
    poseSwing(bodies, animation, time);
    return;
  }
  const { times, poses } = animation;
  const frame = indexAt(times, time);
  const next = Math.min(frame + 1, times.length - 1);
  const span = times[next] - times[frame];
  const part = span > 0 ? Math.min(1, Math.max(0, (time - times[frame]) / span)) : 0;
  bodies.forEach((group, body) => {
    const a = poseOffset(animation, frame, body);
    const b = poseOffset(animation, next, body);
    group.position.lerpVectors(before.fromArray(poses, a), after.fromArray(poses, b), part);
    group.quaternion.slerpQuaternions(turn.fromArray(poses, a + 3), turnAfter.fromArray(poses, b + 3), part);
  });
}
