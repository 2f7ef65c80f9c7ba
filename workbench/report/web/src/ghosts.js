// Other results beside the first one: their mechanisms, translucent, at the same time.

import { Color, Vector3 } from "three";
import { linkObject } from "./links.js";
import { poseBodies } from "./poses.js";
import { bodyGroup } from "./shapes.js";
import { curveColour } from "./theme.js";

const kOpacity = 0.32;
const kTint = 0.55; // share of the ghost's own colour

/** Makes everything in an object translucent, in a colour of its own; it casts no shadow. */
function fade(object, tint) {
  object.traverse((part) => {
    part.castShadow = false;
    part.receiveShadow = false;
    if (!part.material) return;
    part.material = part.material.clone();
    part.material.color.lerp(tint, kTint);
    Object.assign(part.material, { transparent: true, opacity: Math.min(kOpacity, part.material.opacity), depthWrite: false });
    part.renderOrder = 1;
  });
}

/** A mechanism of another result; colour: number of its curve. */
function createGhost({ scene, animation }, colour) {
  const tint = new Color(curveColour(colour));
  const bodies = scene.bodies.map((body, index) => bodyGroup(body, index, scene.size));
  poseBodies(bodies, animation, animation.start);
  const places = (link) => [link.from, link.to].map(([body, at]) => (
    new Vector3(...at).applyQuaternion(bodies[body].quaternion).add(bodies[body].position)));
  const links = scene.links.map((link) => {
    const [from, to] = places(link);
    return { link, ...linkObject(link, from.distanceTo(to)) };
  });
  const objects = [...bodies, ...links.map(({ group }) => group)];
  objects.forEach((object) => fade(object, tint));
  return {
    objects,
    bodies,
    pose(time) {
      poseBodies(bodies, animation, Math.min(animation.end, Math.max(animation.start, time)));
      links.forEach(({ link, place }) => place(...places(link)));
    },
  };
}

/** others: results with a scene and an animation each; none of pages with one result. */
export function createGhosts(others = []) {
  const ghosts = others.map((other, i) => createGhost(other, i + 1));
  return {
    objects: ghosts.flatMap(({ objects }) => objects),
    pose: (time) => ghosts.forEach((ghost) => ghost.pose(time)),
    /** Where a body of a ghost is drawn, for tests. */
    place: (ghost, body) => ghosts[ghost].bodies[body].position.toArray(),
  };
}
