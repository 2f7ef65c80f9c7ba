// All objects of a scene, in layers that can be hidden.

import { Scene, Vector3 } from "three";
import { createArrows } from "./arrows.js";
import { createCourse } from "./course.js";
import { createGhosts } from "./ghosts.js";
import { createGround, createTracks, roadHeights } from "./ground.js";
import { createLights } from "./lights.js";
import { linkObject } from "./links.js";
import { poseBodies, poseForCamera } from "./poses.js";
import { createRoads } from "./road.js";
import { bodyGroup, jointMark } from "./shapes.js";

/** Layers that can be shown and hidden, and whether each is shown at first. */
export const kLayers = { bodies: true, hulls: true, links: true, joints: true, forces: true, ground: true, tracks: true, course: true, ghosts: true, names: false };

/** Bodies with the marks of their joints, in layers. */
function createBodies(scene) {
  const bodies = scene.bodies.map((body, index) => bodyGroup(body, index, scene.size));
  scene.joints.forEach((joint) => {
    const mark = jointMark(joint, scene.up);
    mark.userData.layer = "joints";
    bodies[joint.body].add(mark);
  });
  return bodies;
}

/** table: of a result, whose forces are drawn; undefined of modes. others: further results, drawn as ghosts. */
export function createWorld(scene, animation, table, others) {
  const world = new Scene();
  const bodies = createBodies(scene);
  world.add(...bodies);
  const arrows = createArrows(scene, table, bodies);
  poseForCamera(bodies, animation, animation.start);

  const ends = [new Vector3(), new Vector3()];
  /** Where the ends of a link are, as the bodies stand now. */
  function endPlaces(link) {
    [link.from, link.to].forEach(([body, at], i) => {
      ends[i].set(...at).applyQuaternion(bodies[body].quaternion).add(bodies[body].position);
    });
    return ends;
  }
  const links = scene.links.map((link) => {
    const [from, to] = endPlaces(link);
    return { link, ...linkObject(link, from.distanceTo(to)) };
  });
  links.forEach(({ group }) => world.add(group)); // there may be none, which add refuses

  const height = scene.road ?? scene.ground?.floor ?? scene.floor;
  const ground = height === null ? null : createGround(scene, height);
  const roads = scene.ground ? createRoads(scene) : null;
  const hasWheels = scene.road !== null || scene.ground;
  const tracks = hasWheels && animation.kind !== "mode" ? createTracks(scene, animation) : null;
  const course = animation.kind === "mode" ? null : createCourse(scene, roadHeights(scene, animation));
  const ghosts = createGhosts(others);
  const lights = createLights(scene);
  world.add(...lights.objects, ...ghosts.objects, ...[ground, roads, tracks, course].flatMap((part) => (part ? [part.group] : [])));

  const inLayer = (name) => {
    const found = [];
    world.traverse((object) => object.userData.layer === name && found.push(object));
    return found;
  };
  const layers = {
    bodies: bodies.flatMap((body) => body.children.filter((child) => !child.userData.layer)),
    hulls: inLayer("hulls"),
    links: links.map(({ group }) => group),
    joints: inLayer("joints"),
    forces: arrows.objects,
    ground: [ground, roads].flatMap((part) => (part ? [part.group] : [])),
    tracks: tracks ? [tracks.group] : [],
    course: course ? [course.group] : [],
    ghosts: ghosts.objects,
  };

  return {
    scene: world,
    bodies,
    ground,
    roads,
    tracks,
    course,
    ghosts,
    lights,
    layers,
    endPlaces,
    drawnForces: arrows.drawn,
    /** Puts bodies, links and forces where they are at a time of an animation. */
    pose(shown, time) {
      poseBodies(bodies, shown, time);
      arrows.show(time);
      ghosts.pose(time);
      links.forEach(({ link, place }) => place(...endPlaces(link)));
    },
  };
}
