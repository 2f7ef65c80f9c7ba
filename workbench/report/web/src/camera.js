// Cameras: each is a place to look at and how the viewer goes with it. All of them orbit by mouse, touch and keys.

import { PerspectiveCamera, Spherical, Quaternion, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

const kField = 34; // degrees
const kTurn = 0.09; // rad a key
const kZoom = 1.12;

/** Names of the cameras of a scene. */
export function cameraNames(scene) {
  return scene.follow >= 0 ? ["follow", "chase", "beside the road", "from above"] : ["orbit", "from above"];
}

/** looked: what is looked at, see target.js. */
export function createCamera(scene, element, looked) {
  const up = new Vector3(...scene.up);
  const camera = new PerspectiveCamera(kField, 1, 0.02 * scene.size, 40 * scene.size);
  camera.up.copy(up);
  const controls = new OrbitControls(camera, element);
  controls.enableDamping = false;
  controls.maxDistance = 12 * scene.size;
  controls.minDistance = 0.05 * scene.size;
  controls.target.set(...scene.centre);
  let mode = cameraNames(scene)[0];
  const target = new Vector3(...scene.centre);
  let yaw = null;

  /** A direction in the plane of the ground, `angle` from the body's heading. */
  function around(angle) {
    return looked.heading.clone().applyAxisAngle(up, angle);
  }

  function place(angle, elevation, distance) {
    const direction = around(angle).multiplyScalar(Math.cos(elevation)).addScaledVector(up, Math.sin(elevation));
    camera.position.copy(controls.target).addScaledVector(direction, distance * looked.reach());
    controls.update();
  }

  function choose(name, centre) {
    mode = name;
    yaw = null;
    target.copy(centre);
    controls.target.copy(centre);
    controls.enableRotate = true;
    if (name === "from above") place(Math.PI, 1.5, 2.6);
    else if (name === "chase") place(Math.PI, 0.32, 1.9);
    else if (name === "beside the road") {
      controls.target.copy(centre).addScaledVector(around(0), 1.6 * looked.reach());
      place(-1.9, 0.3, 2.4);
      controls.target.copy(centre);
      controls.update();
    } else place(0.66, 0.3, 1.62);
  }

  /** Goes with the place to look at; in the chase with its heading too. */
  function follow(centre) {
    if (mode === "beside the road") {
      target.copy(centre);
      controls.target.copy(centre);
      controls.update();
      return;
    }
    const moved = new Vector3().subVectors(centre, target);
    target.copy(centre);
    controls.target.add(moved);
    camera.position.add(moved);
    if (mode === "chase") turnWith();
    controls.update();
  }

  function turnWith() {
    const ahead = looked.heading;
    if (yaw) {
      const angle = Math.atan2(new Vector3().crossVectors(yaw, ahead).dot(up), yaw.dot(ahead));
      const arm = new Vector3().subVectors(camera.position, controls.target).applyAxisAngle(up, angle);
      camera.position.copy(controls.target).add(arm);
    }
    yaw = ahead.clone();
  }

  /** Turns by steps around the target, and nearer or further. */
  function orbit(sideways, upwards, nearer) {
    const toZ = new Quaternion().setFromUnitVectors(up, new Vector3(0, 1, 0));
    const arm = new Vector3().subVectors(camera.position, controls.target).applyQuaternion(toZ);
    const spherical = new Spherical().setFromVector3(arm);
    spherical.theta += sideways * kTurn;
    spherical.phi -= upwards * kTurn;
    spherical.radius *= kZoom ** -nearer;
    spherical.makeSafe();
    arm.setFromSpherical(spherical).applyQuaternion(toZ.invert());
    camera.position.copy(controls.target).add(arm);
    controls.update();
  }

  return { camera, controls, choose, follow, orbit, mode: () => mode };
}
