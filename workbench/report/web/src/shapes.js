// Meshes of bodies: what workbench/report/scene.cpp says of them, in their frames.

import {
  BoxGeometry, CylinderGeometry, EdgesGeometry, Group, LatheGeometry, LineBasicMaterial, LineSegments, Mesh,
  MeshStandardMaterial, SphereGeometry, Vector2, Vector3,
} from "three";

const kRound = 24; // sides of a cylinder
const kUpOfCylinder = new Vector3(0, 1, 0);
/** Boxes whose second side is larger than this share of the scene show what is inside them. */
const kSeeThroughFrom = 0.08;

/** Muted colours, far enough apart for neighbours in a list. */
const kBodyColours = ["#5b7c99", "#a8763e", "#5f8f6a", "#8a6a9e", "#b0594f", "#4f8f93", "#8b8550", "#6b7684"];

export function bodyColour(index) {
  return kBodyColours[index % kBodyColours.length];
}

export function material(colour, options = {}) {
  return new MeshStandardMaterial({ color: colour, roughness: 0.62, metalness: 0.12, ...options });
}

/** Turns an object so that its y axis points along a direction. */
export function alignY(object, direction) {
  object.quaternion.setFromUnitVectors(kUpOfCylinder, direction);
}

function shadowed(mesh) {
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  return mesh;
}

/** A cylinder between two places. */
export function bar(from, to, radius, surface, sides = kRound) {
  const a = new Vector3(...from);
  const axis = new Vector3(...to).sub(a);
  const length = axis.length() || 1e-9;
  const mesh = shadowed(new Mesh(new CylinderGeometry(radius, radius, length, sides), surface));
  mesh.position.copy(a).addScaledVector(axis, 0.5);
  alignY(mesh, axis.normalize());
  return mesh;
}

export function ball(at, radius, surface) {
  const mesh = shadowed(new Mesh(new SphereGeometry(radius, 20, 14), surface));
  mesh.position.set(...at);
  return mesh;
}

/** Rubber, rim and the holes of a disc wheel, which show that it turns. */
function tyre({ at, axis, radius, width }) {
  const group = new Group();
  const half = width / 2;
  const rim = 0.56 * radius;
  const profile = [
    [rim, -0.82 * half], [0.72 * radius, -half], [0.9 * radius, -0.98 * half], [0.975 * radius, -0.82 * half],
    [radius, -0.6 * half], [radius, 0.6 * half], [0.975 * radius, 0.82 * half], [0.9 * radius, 0.98 * half],
    [0.72 * radius, half], [rim, 0.82 * half],
  ].map(([r, y]) => new Vector2(r, y));
  const rubber = material("#24272b", { roughness: 0.92, metalness: 0 });
  const steel = material("#c3c9cf", { roughness: 0.35, metalness: 0.45 });
  const dark = material("#33383e", { roughness: 0.8 });
  group.add(shadowed(new Mesh(new LatheGeometry(profile, 48), rubber)));
  const groove = 0.018 * radius;
  for (const y of [-0.3, 0.3]) {
    const ring = new Mesh(new CylinderGeometry(1.002 * radius, 1.002 * radius, groove, 48, 1, true), dark);
    ring.position.y = y * half;
    group.add(ring);
  }
  const disc = shadowed(new Mesh(new CylinderGeometry(rim, rim, 1.3 * half, 40), steel));
  const hub = shadowed(new Mesh(new CylinderGeometry(0.2 * radius, 0.24 * radius, 1.7 * half, 24), steel));
  group.add(disc, hub);
  const holes = 8;
  for (let i = 0; i < holes; ++i) {
    const angle = (2 * Math.PI * i) / holes;
    const hole = new Mesh(new CylinderGeometry(0.065 * radius, 0.065 * radius, 1.33 * half, 14), dark);
    hole.position.set(0.41 * radius * Math.cos(angle), 0, 0.41 * radius * Math.sin(angle));
    group.add(hole);
  }
  group.position.set(...at);
  alignY(group, new Vector3(...axis).normalize());
  return group;
}

function box({ at, size, hull }, surface, sceneSize) {
  const group = new Group();
  const second = [...size].sort((a, b) => a - b)[1];
  const seeThrough = hull || second > kSeeThroughFrom * sceneSize;
  const geometry = new BoxGeometry(...size);
  const mesh = new Mesh(geometry, surface);
  if (seeThrough) {
    mesh.material = surface.clone();
    Object.assign(mesh.material, { transparent: true, opacity: hull ? 0.2 : 0.34, depthWrite: false });
    mesh.renderOrder = 2;
    mesh.castShadow = true;
  } else {
    shadowed(mesh);
  }
  const edges = new LineSegments(
    new EdgesGeometry(geometry),
    new LineBasicMaterial({ color: surface.color.clone().multiplyScalar(0.55), transparent: true, opacity: 0.7 }),
  );
  edges.renderOrder = 3;
  group.add(mesh, edges);
  group.position.set(...at);
  if (seeThrough) group.userData.layer = "hulls";
  return group;
}

/** One shape of a body, in the body's frame. */
function shapeMesh(shape, surface, sceneSize) {
  const own = shape.colour ? material(shape.colour) : surface;
  if (shape.kind === "tyre") return tyre(shape);
  if (shape.kind === "box") return box(shape, own, sceneSize);
  if (shape.kind === "sphere") return ball(shape.at, shape.radius, own);
  const group = new Group();
  group.add(bar(shape.from, shape.to, shape.radius, own));
  if (shape.kind === "tube") group.add(ball(shape.from, 1.05 * shape.radius, own), ball(shape.to, 1.05 * shape.radius, own));
  return group;
}

/** A group a body, to be placed by its pose. */
export function bodyGroup(body, index, sceneSize) {
  const group = new Group();
  const surface = material(bodyColour(index));
  body.shapes.forEach((shape) => group.add(shapeMesh(shape, surface, sceneSize)));
  return group;
}

/** The mark of a joint: a pin, a ball, a slide, a sleeve about a pin, a pad, or a foot on the ground. */
export function jointMark(joint, up) {
  const surface = material(joint.on_ground ? "#7b838c" : "#e0a526", { roughness: 0.45 });
  const group = new Group();
  const r = joint.radius;
  const axis = new Vector3(...joint.axis).normalize();
  if (joint.kind === "revolute" || joint.kind === "cylindrical") {
    const pin = shadowed(new Mesh(new CylinderGeometry(r, r, 4.4 * r, 18), surface));
    alignY(pin, axis);
    group.add(pin);
  } else if (joint.kind === "prismatic") {
    const slide = shadowed(new Mesh(new BoxGeometry(2 * r, 5 * r, 2 * r), surface));
    alignY(slide, axis);
    group.add(slide);
  } else if (joint.axes) {
    const rubber = material("#3a3f46", { roughness: 0.85, metalness: 0 });
    const sleeve = shadowed(new Mesh(new CylinderGeometry(1.9 * r, 1.9 * r, 3.4 * r, 24), rubber));
    const pin = shadowed(new Mesh(new CylinderGeometry(0.8 * r, 0.8 * r, 4.6 * r, 18), material("#7b838c")));
    alignY(sleeve, axis);
    alignY(pin, axis);
    group.add(sleeve, pin);
  } else if (joint.mark === "pad") {
    const rubber = material("#3a3f46", { roughness: 0.85, metalness: 0 });
    const stop = shadowed(new Mesh(new CylinderGeometry(0.9 * r, 1.7 * r, 4 * r, 24), rubber));
    stop.position.copy(axis).multiplyScalar(2 * r);
    alignY(stop, axis);
    group.add(stop);
  } else {
    group.add(ball([0, 0, 0], 1.3 * r, surface));
  }
  if (joint.on_ground) {
    const foot = shadowed(new Mesh(new CylinderGeometry(1.4 * r, 3.2 * r, 4 * r, 20), surface));
    const upwards = new Vector3(...up);
    foot.position.copy(upwards).multiplyScalar(-2.6 * r);
    alignY(foot, upwards);
    group.add(foot);
  }
  group.position.set(...joint.at);
  return group;
}
