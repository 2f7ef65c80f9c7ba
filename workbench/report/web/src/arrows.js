// Arrows of the forces of elements with a frame, as they act on the body of `to`.

import { ConeGeometry, CylinderGeometry, Group, Mesh, Vector3 } from "three";
import { valueAt } from "./data.js";
import { alignY, material } from "./shapes.js";

const kLongest = 0.12; // of the scene's size: the largest force of the motion
const kThickness = 0.003; // of the scene's size
const kHead = 5; // length of the head over the shaft's radius

/** An arrow along y from the origin, and a function that gives it a direction and a length (Vector3, m). */
function arrowObject(radius) {
  const surface = material("#d23c3c", { roughness: 0.6 });
  const shaft = new Mesh(new CylinderGeometry(radius, radius, 1, 12), surface);
  const head = new Mesh(new ConeGeometry(2.6 * radius, kHead * radius, 16), surface);
  const group = new Group();
  group.add(shaft, head);
  group.userData.layer = "forces";
  const direction = new Vector3();
  return {
    group,
    point(vector) {
      const length = vector.length();
      const straight = Math.max(length - kHead * radius, 1e-9);
      group.scale.setScalar(length > 1e-3 * radius ? 1 : 0);
      shaft.scale.y = straight;
      shaft.position.y = straight / 2;
      head.position.y = straight + (kHead * radius) / 2;
      if (length > 0) alignY(group, direction.copy(vector).divideScalar(length));
    },
  };
}

/** The three columns of an element's force, or null where the table has none. */
function forceColumns(table, name) {
  const columns = ["x", "y", "z"].map((axis) => table.columns.find((column) => column.name === `${name}.force_${axis}`));
  return columns.every(Boolean) ? columns : null;
}

function largestForce(columns) {
  let largest = 0;
  columns[0].values.forEach((_, row) => {
    largest = Math.max(largest, Math.hypot(...columns.map(({ values }) => values[row])));
  });
  return largest;
}

/** Puts an arrow on the body of each element with a frame whose force the table has; a function shows them at a time. */
export function createArrows(scene, table, bodies) {
  const arrows = scene.joints.flatMap((joint) => {
    const columns = joint.axes && table ? forceColumns(table, joint.name) : null;
    if (!columns) return [];
    const arrow = arrowObject(kThickness * scene.size);
    arrow.group.position.set(...joint.at);
    bodies[joint.body].add(arrow.group);
    return [{ ...arrow, name: joint.name, columns, axes: joint.axes.map((axis) => new Vector3(...axis)) }];
  });
  const largest = Math.max(0, ...arrows.map(({ columns }) => largestForce(columns)));
  const scale = largest > 0 ? (kLongest * scene.size) / largest : 0; // m/N
  const vector = new Vector3();

  /** The force of an element at a time, N, in the axes of its body. */
  function forceAt({ axes, columns }, time) {
    vector.set(0, 0, 0);
    axes.forEach((axis, k) => vector.addScaledVector(axis, valueAt(table.times, columns[k].values, time)));
    return vector;
  }
  return {
    objects: arrows.map(({ group }) => group),
    show(time) {
      arrows.forEach((arrow) => arrow.point(forceAt(arrow, time).multiplyScalar(scale)));
    },
    /** Names with lengths as drawn, in the unit of the force, for tests. */
    drawn: () => arrows.map(({ name, group }) => {
      const [shaft] = group.children;
      return { name, force: group.scale.x * (shaft.scale.y + kHead * kThickness * scene.size) / scale };
    }),
  };
}
