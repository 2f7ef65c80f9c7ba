// Target of the camera: a body that it follows, or the middle of the model.

import { Box3, Vector3 } from "three";

/** Looks at the scene's own choice at first; bodies: their groups, posed. */
export function createTarget(scene, bodies) {
  const up = new Vector3(...scene.up);
  const pin = scene.joints.find((joint) => joint.on_ground && joint.kind === "revolute");
  const centre = new Vector3();
  const heading = new Vector3(1, 0, 0);
  const middle = new Vector3(); // of the followed body, in its frame
  const whole = new Vector3(); // of the vehicle, in the frame of the scene's own choice
  let followed = scene.follow;
  let reach = scene.size;

  /** Where the vehicle heads, in the plane of the ground; without one the camera stands before a joint's axis. */
  function turnHead() {
    if (scene.follow >= 0) heading.set(1, 0, 0).applyQuaternion(bodies[scene.follow].quaternion);
    else if (pin) heading.set(...pin.axis).applyQuaternion(bodies[pin.body].quaternion).negate();
    heading.addScaledVector(up, -heading.dot(up));
    if (heading.lengthSq() < 0.25) heading.set(0, -1, 0);
    heading.normalize();
  }

  /** Follows a body, -1 for the whole model. The scene's own choice stands for all of the vehicle. */
  function choose(body) {
    followed = body;
    reach = scene.size;
    if (body < 0) return;
    if (body === scene.follow) {
      middle.copy(whole);
      return;
    }
    const box = new Box3().setFromObject(bodies[body]);
    toFrame(box.getCenter(middle), body);
    reach = Math.max(0.22 * scene.size, 1.6 * box.getSize(new Vector3()).length());
  }

  function toFrame(place, body) {
    const { position, quaternion } = bodies[body];
    return place.sub(position).applyQuaternion(quaternion.clone().invert());
  }

  if (followed >= 0) toFrame(whole.set(...scene.centre), followed);
  choose(followed);
  turnHead();
  return {
    choose,
    heading,
    /** Size of what is looked at, m. */
    reach: () => reach,
    /** Its place as the bodies stand now; the heading follows. */
    centre() {
      if (scene.follow >= 0) turnHead();
      if (followed < 0) return centre.set(...scene.centre);
      return centre.copy(middle).applyQuaternion(bodies[followed].quaternion).add(bodies[followed].position);
    },
  };
}
