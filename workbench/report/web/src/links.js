// Links between two bodies that change their length: rods, springs, dampers, struts, air springs.

import { CatmullRomCurve3, CylinderGeometry, Group, LatheGeometry, Mesh, TubeGeometry, Vector2, Vector3 } from "three";
import { alignY, ball, material } from "./shapes.js";

function part(geometry, surface) {
  const mesh = new Mesh(geometry, surface);
  mesh.castShadow = true;
  return mesh;
}

/** A coil of length 1 along y; stretched by its scale. length: at first, it decides how many turns there are. */
function coil(radius, length) {
  const points = [];
  const turns = Math.min(14, Math.max(5, Math.round(length / (0.9 * radius))));
  const steps = turns * 14;
  for (let i = 0; i <= steps; ++i) {
    const angle = (2 * Math.PI * turns * i) / steps;
    points.push(new Vector3(radius * Math.cos(angle), 0.04 + (0.92 * i) / steps, radius * Math.sin(angle)));
  }
  return part(new TubeGeometry(new CatmullRomCurve3(points), steps * 2, 0.15 * radius, 7), material("#c9912b"));
}

/** Folds of an air spring of length 1 along y. */
function bellows(radius) {
  const profile = [[0.72, 0], [0.8, 0.03]];
  const folds = 3;
  for (let i = 0; i < folds; ++i) {
    for (const [r, y] of [[0.86, 0.02], [1, 0.28], [1.04, 0.5], [1, 0.72], [0.86, 0.98]]) {
      profile.push([r, 0.05 + (0.9 * (i + y)) / folds]);
    }
  }
  profile.push([0.8, 0.97], [0.72, 1]);
  const rubber = material("#3a3f46", { roughness: 0.85, metalness: 0 });
  return part(new LatheGeometry(profile.map(([r, y]) => new Vector2(r * radius, y)), 28), rubber);
}

function cylinder(radius, length, colour) {
  const mesh = part(new CylinderGeometry(radius, radius, length, 18), material(colour, { roughness: 0.4, metalness: 0.3 }));
  return mesh;
}

/** A tube at one end and a rod at the other, which slides in it. */
function damper(radius, length) {
  const tube = cylinder(radius, 0.58 * length, "#4c6f8f");
  const rod = cylinder(0.42 * radius, 0.62 * length, "#cfd5db");
  return {
    objects: [tube, rod],
    stretch(now) {
      tube.position.y = 0.29 * length;
      rod.position.y = now - 0.31 * length;
    },
  };
}

function stretched(mesh) {
  return {
    objects: [mesh],
    stretch(now) {
      mesh.scale.y = now;
    },
  };
}

function parts(link, length) {
  const { kind, radius } = link;
  if (kind === "damper") return [damper(radius, length)];
  if (kind === "spring") return [stretched(coil(radius, length))];
  if (kind === "air_spring") return [stretched(bellows(radius))];
  if (kind === "strut") return [stretched(coil(radius, length)), damper(0.42 * radius, length)];
  const rod = cylinder(radius, 1, "#c2603a");
  return [{
    objects: [rod],
    stretch(now) {
      rod.scale.y = now;
      rod.position.y = now / 2;
    },
  }];
}

/** A link as an object and a function that puts it between two places (Vector3). */
export function linkObject(link, length) {
  const group = new Group();
  const pieces = parts(link, length || 1e-6);
  pieces.forEach((piece) => group.add(...piece.objects));
  const ends = [0, 1].map(() => ball([0, 0, 0], (link.kind === "rod" ? 1.3 : 0.5) * link.radius, material("#7b838c")));
  group.add(...ends);
  const axis = new Vector3();
  return {
    group,
    place(from, to) {
      axis.subVectors(to, from);
      const now = Math.max(axis.length(), 1e-9);
      group.position.copy(from);
      alignY(group, axis.divideScalar(now));
      ends[1].position.y = now;
      pieces.forEach((piece) => piece.stretch(now));
    },
  };
}
