// The road or the floor: a plane with a grid that goes with the camera, and the tracks of the tyres on it.

import {
  BufferAttribute, BufferGeometry, CircleGeometry, Group, Line, LineBasicMaterial, LineSegments, Mesh,
  MeshStandardMaterial, Quaternion, Vector3,
} from "three";
import { originAt, poseOffset } from "./data.js";
import { niceStep } from "./numbers.js";

const kLines = 60; // to each side
const kMostTrackPoints = 1500;

function gridLines(step, every) {
  const reach = kLines * step;
  const piece = 4 * step;
  const places = [];
  for (let i = -kLines; i <= kLines; ++i) {
    if ((i % 5 === 0) !== every) continue;
    // In pieces: some rasterisers lose a line that passes behind the camera.
    for (let from = -reach; from < reach; from += piece) {
      places.push(i * step, from, 0, i * step, from + piece, 0, from, i * step, 0, from + piece, i * step, 0);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(places), 3));
  return geometry;
}

/** The ground of a scene at a height along `up`. */
export function createGround(scene, height) {
  const up = new Vector3(...scene.up);
  const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), up);
  const back = turn.clone().invert();
  const step = niceStep(scene.size / 8);
  const group = new Group();
  group.quaternion.copy(turn);
  const plane = new Mesh(new CircleGeometry(1.4 * kLines * step, 64), new MeshStandardMaterial({
    roughness: 1, metalness: 0, polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2,
  }));
  plane.receiveShadow = true;
  plane.position.z = -0.0008 * scene.size;
  const fine = new LineSegments(gridLines(step, false), new LineBasicMaterial({ transparent: true, opacity: 0.45 }));
  const coarse = new LineSegments(gridLines(step, true), new LineBasicMaterial({ transparent: true, opacity: 0.9 }));
  group.add(plane, fine, coarse);
  const local = new Vector3();
  const jump = 5 * step;
  return {
    group,
    step,
    /** Moves the grid under a place, by whole lines. */
    follow(place) {
      local.copy(place).applyQuaternion(back);
      local.set(Math.round(local.x / jump) * jump, Math.round(local.y / jump) * jump, height);
      group.position.copy(local.applyQuaternion(turn));
    },
    paint(colours) {
      plane.material.color.set(colours.ground);
      fine.material.color.set(colours.grid);
      coarse.material.color.set(colours.grid);
    },
  };
}

/** Where the wheels of a scene are and how high the road is under them in a frame of the animation. */
function trackedWheels(scene) {
  if (scene.ground) {
    return scene.ground.tracks.map(({ body, at, heights }) => ({ body, at, height: (frame) => heights[frame] }));
  }
  return scene.bodies.flatMap(({ shapes }, body) => {
    const tyre = shapes.find((shape) => shape.kind === "tyre");
    return tyre ? [{ body, at: tyre.at, height: () => scene.road }] : [];
  });
}

/** Height of the road at a place [x, y]: below the nearest place of a wheel, where the road is not a plane. */
export function roadHeights(scene, animation) {
  if (!scene.ground) return () => scene.road ?? scene.floor ?? 0;
  const stride = Math.max(1, Math.ceil(animation.times.length / kMostTrackPoints));
  const known = [];
  trackedWheels(scene).forEach(({ body, at, height }) => {
    for (let frame = 0; frame < animation.times.length; frame += stride) {
      const place = new Vector3(...originAt(animation, body, animation.times[frame])).add(wheelOffset(animation, body, frame, at));
      known.push([place.x, place.y, height(frame)]);
    }
  });
  return ([x, y]) => {
    let nearest = Infinity;
    let found = scene.ground.floor ?? 0;
    known.forEach(([kx, ky, height]) => {
      const far = (kx - x) ** 2 + (ky - y) ** 2;
      if (far < nearest) [nearest, found] = [far, height];
    });
    return found;
  };
}

/** Lines of the wheels' paths on the road. */
export function createTracks(scene, animation) {
  const group = new Group();
  const up = new Vector3(...scene.up);
  const stride = Math.max(1, Math.ceil(animation.times.length / kMostTrackPoints));
  trackedWheels(scene).forEach(({ body, at, height }) => {
    const places = [];
    for (let frame = 0; frame < animation.times.length; frame += stride) {
      const place = new Vector3(...originAt(animation, body, animation.times[frame]));
      place.add(wheelOffset(animation, body, frame, at));
      place.addScaledVector(up, height(frame) - place.dot(up) + 0.0012 * scene.size);
      places.push(place.x, place.y, place.z);
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(places), 3));
    const line = new Line(geometry, new LineBasicMaterial({ transparent: true, opacity: 0.75 }));
    line.frustumCulled = false;
    group.add(line);
  });
  return {
    group,
    paint: (colours) => group.children.forEach((line) => line.material.color.set(colours.track)),
  };
}

/** From a body's origin to a place in its frame, in a frame of the animation. */
function wheelOffset(animation, body, frame, at) {
  const i = poseOffset(animation, frame, body) + 3;
  const turn = new Quaternion(...animation.poses.subarray(i, i + 4));
  return new Vector3(...at).applyQuaternion(turn);
}
