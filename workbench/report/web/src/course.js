// The course of a manoeuvre on the road: cones at the limits of its lanes, and the way that the driver is to go.

import {
  BufferAttribute, BufferGeometry, ConeGeometry, CylinderGeometry, Group, InstancedMesh, Line, LineDashedMaterial,
  LineSegments, LineBasicMaterial, Matrix4, Quaternion, Vector3,
} from "three";
import { material } from "./shapes.js";

const kConeHeight = 0.5; // m, the least of ISO 3888
const kConeRadius = 0.14;
const kBetweenCones = 3; // m at most

const isPlace = (place) => Array.isArray(place) && place.length === 2 && place.every(Number.isFinite);
const isLimit = (limit) => Array.isArray(limit) && limit.length === 2 && limit.every(isPlace);

/** Lanes and course of a run, without anything that is no place. */
export function courseOf(run) {
  const listed = (value) => (Array.isArray(value) ? value : []);
  return {
    lanes: listed(run?.manoeuvre?.lanes).filter((lane) => isLimit(lane?.left) && isLimit(lane?.right)),
    course: listed(run?.manoeuvre?.course).filter(isPlace),
  };
}

/** Places of the cones along a limit, both ends among them. */
export function conesAlong([from, to]) {
  const count = Math.max(1, Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) / kBetweenCones - 1e-9));
  return Array.from({ length: count + 1 }, (unused, i) => [0, 1].map((k) => from[k] + ((to[k] - from[k]) * i) / count));
}

function linesThrough(places, Kind, surface) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(places.flat()), 3));
  const line = new Kind(geometry, surface);
  line.frustumCulled = false;
  return line;
}

/** Cones with their feet at some places. */
function coneMeshes(places, turn) {
  const part = (geometry, colour, height) => {
    const mesh = new InstancedMesh(geometry, material(colour, { roughness: 0.7, metalness: 0 }), places.length);
    const lifted = new Vector3(0, height, 0).applyQuaternion(turn);
    places.forEach((place, i) => {
      mesh.setMatrixAt(i, new Matrix4().compose(new Vector3(...place).add(lifted), turn, new Vector3(1, 1, 1)));
    });
    mesh.castShadow = true;
    mesh.frustumCulled = false;
    return mesh;
  };
  return [
    part(new ConeGeometry(kConeRadius, kConeHeight, 20), "#e8641b", kConeHeight / 2),
    part(new CylinderGeometry(0.5 * kConeRadius, 0.68 * kConeRadius, 0.18 * kConeHeight, 20), "#f4f4f0", 0.41 * kConeHeight),
    part(new CylinderGeometry(1.35 * kConeRadius, 1.35 * kConeRadius, 0.04, 4), "#e8641b", 0.02),
  ];
}

/** heightAt: of the road at a place [x, y]. Null without a course. */
export function createCourse(scene, heightAt) {
  const { lanes, course } = scene.course ?? { lanes: [], course: [] };
  if (lanes.length === 0 && course.length < 2) return null;
  const group = new Group();
  const above = 0.0016 * scene.size;
  const onRoad = ([x, y], lift = 0) => [x, y, heightAt([x, y]) + lift];
  const limits = lanes.flatMap(({ left, right }) => [left, right]);
  const cones = limits.flatMap(conesAlong);
  const lines = [];
  if (cones.length > 0) {
    group.add(...coneMeshes(cones.map((place) => onRoad(place)),
      new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), new Vector3(...scene.up))));
    const ends = limits.flatMap((limit) => {
      const places = conesAlong(limit);
      return places.slice(1).flatMap((place, i) => [onRoad(places[i], above), onRoad(place, above)]);
    });
    lines.push(linesThrough(ends, LineSegments, new LineBasicMaterial()));
  }
  if (course.length > 1) {
    const way = linesThrough(course.map((place) => onRoad(place, above)), Line,
      new LineDashedMaterial({ dashSize: 1, gapSize: 1 }));
    way.computeLineDistances();
    lines.push(way);
  }
  group.add(...lines);
  return {
    group,
    /** Numbers of lanes and cones drawn, for tests. */
    drawn: { lanes: lanes.length, cones: cones.length, course: course.length },
    paint: (colours) => lines.forEach((line) => line.material.color.set(colours.course)),
  };
}
