// The animation: a scene in three.js, posed for the player's time.

import {
  AmbientLight, Box3, Color, DirectionalLight, Fog, HemisphereLight, PCFShadowMap, Quaternion, Scene, Vector3, WebGLRenderer,
} from "three";
import { cameraNames, createCamera } from "./camera.js";
import { indexAt, poseOffset } from "./data.js";
import { createGround, createTracks } from "./ground.js";
import { linkObject } from "./links.js";
import { bodyGroup, dispose, jointMark } from "./shapes.js";
import { colour, onThemeChange } from "./theme.js";

/** What can be shown and hidden: name and whether it is at first. */
export const kLayers = { bodies: true, hulls: true, links: true, joints: true, ground: true, tracks: true, names: false };

export function createView(scene, animation, element) {
  const renderer = new WebGLRenderer({ antialias: true });
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
  element.append(renderer.domElement);
  const world = new Scene();
  const up = new Vector3(...scene.up);
  const heading = new Vector3(1, 0, 0);
  let shown = animation;

  const bodies = scene.bodies.map((body, index) => bodyGroup(body, index, scene.size));
  const joints = scene.joints.map((joint) => {
    const mark = jointMark(joint, scene.up);
    mark.userData.layer = "joints";
    bodies[joint.body].add(mark);
    return mark;
  });
  world.add(...bodies);

  const ends = [new Vector3(), new Vector3()];
  /** Puts the ends of a link where their bodies are. */
  function endPlaces(link) {
    [link.from, link.to].forEach(([body, at], i) => {
      ends[i].set(...at).applyQuaternion(bodies[body].quaternion).add(bodies[body].position);
    });
    return ends;
  }

  const before = new Vector3();
  const after = new Vector3();
  const turn = new Quaternion();
  const turnAfter = new Quaternion();
  /** Poses of all bodies at a time, between frames. */
  function pose(time) {
    const { times, poses } = shown;
    const frame = indexAt(times, time);
    const next = Math.min(frame + 1, times.length - 1);
    const span = times[next] - times[frame];
    const part = span > 0 ? Math.min(1, Math.max(0, (time - times[frame]) / span)) : 0;
    bodies.forEach((group, body) => {
      const a = poseOffset(shown, frame, body);
      const b = poseOffset(shown, next, body);
      group.position.lerpVectors(before.fromArray(poses, a), after.fromArray(poses, b), part);
      group.quaternion.slerpQuaternions(turn.fromArray(poses, a + 3), turnAfter.fromArray(poses, b + 3), part);
    });
  }
  pose(animation.start);

  const links = scene.links.map((link) => {
    const [from, to] = endPlaces(link);
    const object = linkObject(link, from.distanceTo(to));
    world.add(object.group);
    return { link, ...object };
  });

  const height = scene.road ?? scene.floor;
  const ground = height === null ? null : createGround(scene, height);
  const tracks = scene.road === null ? null : createTracks(scene, animation, height);
  if (ground) world.add(ground.group);
  if (tracks) world.add(tracks.group);

  const sun = new DirectionalLight("#ffffff", 2.2);
  sun.castShadow = true;
  sun.shadow.mapSize.set(2048, 2048);
  sun.shadow.radius = 3;
  sun.shadow.bias = -0.0006;
  const lit = 0.8 * scene.size;
  Object.assign(sun.shadow.camera, { left: -lit, right: lit, top: lit, bottom: -lit, near: 0.05 * scene.size, far: 6 * scene.size });
  const sky = new HemisphereLight("#ffffff", "#8a8f96", 1.35);
  sky.position.copy(up);
  world.add(sun, sun.target, sky, new AmbientLight("#ffffff", 0.25));

  /** The body that the camera follows, -1 for none, and what it looks at: a place in the body's frame. */
  let follow = scene.follow;
  let reach = scene.size;
  const centre = new Vector3();
  const middle = new Vector3();
  function followBody(body) {
    follow = body;
    reach = scene.size;
    if (body < 0) return;
    const { position, quaternion } = bodies[body];
    if (body === scene.follow) middle.set(...scene.centre);
    else {
      const box = new Box3().setFromObject(bodies[body]);
      box.getCenter(middle);
      reach = Math.max(0.22 * scene.size, 1.6 * box.getSize(new Vector3()).length());
    }
    middle.sub(position).applyQuaternion(quaternion.clone().invert());
  }
  followBody(follow);
  /** Where the vehicle heads, in the plane of the ground; without one the camera stands before a joint's axis. */
  function headNow() {
    if (scene.follow >= 0) heading.set(1, 0, 0).applyQuaternion(bodies[scene.follow].quaternion);
    else if (pin) heading.set(...pin.axis).applyQuaternion(bodies[pin.body].quaternion).negate();
    heading.addScaledVector(up, -heading.dot(up));
    if (heading.lengthSq() < 0.25) heading.set(0, -1, 0);
    heading.normalize();
  }
  const pin = scene.joints.find((joint) => joint.on_ground && joint.kind === "revolute");
  headNow();
  function centreNow() {
    if (follow < 0) return centre.set(...scene.centre);
    if (scene.follow >= 0) headNow();
    return centre.copy(middle).applyQuaternion(bodies[follow].quaternion).add(bodies[follow].position);
  }
  const viewer = createCamera(scene, renderer.domElement, () => heading, () => reach);

  const names = document.createElement("div");
  names.className = "names";
  element.append(names);
  const labels = scene.bodies.map((body) => {
    const label = document.createElement("span");
    label.textContent = body.name;
    if (body.shapes.length > 0) names.append(label);
    return label;
  });

  const layers = { ...kLayers };
  function showLayers() {
    world.traverse((object) => {
      if (object.userData.layer) object.visible = layers[object.userData.layer];
    });
    bodies.forEach((body) => body.children.forEach((child) => {
      if (!child.userData.layer) child.visible = layers.bodies;
    }));
    if (ground) ground.group.visible = layers.ground;
    if (tracks) tracks.group.visible = layers.tracks;
    names.hidden = !layers.names;
    isStale = true;
  }

  function paint() {
    const colours = { ground: colour("ground"), grid: colour("grid"), track: colour("track") };
    world.background = new Color(colour("sky"));
    world.fog = new Fog(colour("sky"), 3.2 * scene.size, 9 * scene.size);
    ground?.paint(colours);
    tracks?.paint(colours);
    isStale = true;
  }

  const projected = new Vector3();
  function placeNames() {
    const { clientWidth, clientHeight } = element;
    labels.forEach((label, body) => {
      if (!label.isConnected) return;
      const box = scene.bodies[body].shapes[0];
      const at = box.at ?? box.from.map((x, i) => (x + box.to[i]) / 2);
      projected.set(...at).applyQuaternion(bodies[body].quaternion).add(bodies[body].position).project(viewer.camera);
      label.hidden = projected.z > 1;
      label.style.transform = `translate(${((projected.x + 1) / 2) * clientWidth}px, ${((1 - projected.y) / 2) * clientHeight}px) translate(-50%, -50%)`;
    });
  }

  function resize() {
    const { clientWidth, clientHeight } = element;
    if (clientWidth === 0 || clientHeight === 0) return;
    renderer.setSize(clientWidth, clientHeight);
    viewer.camera.aspect = clientWidth / clientHeight;
    viewer.camera.updateProjectionMatrix();
    isStale = true;
  }

  let isStale = true;
  let time = animation.start;
  /** Shows a time, when the next picture is drawn. */
  function show(at) {
    time = at;
    isStale = true;
  }

  function draw() {
    if (!isStale) return;
    isStale = false;
    pose(time);
    links.forEach(({ link, place }) => place(...endPlaces(link)));
    viewer.follow(centreNow());
    ground?.follow(viewer.controls.target);
    sun.target.position.copy(centre);
    sun.position.copy(centre).addScaledVector(up, 2 * scene.size).addScaledVector(heading, 0.7 * scene.size);
    sun.position.addScaledVector(new Vector3().crossVectors(up, heading), 0.9 * scene.size);
    renderer.render(world, viewer.camera);
    if (layers.names) placeNames();
    isStale = false;
  }

  viewer.controls.addEventListener("change", () => {
    isStale = true;
  });
  new ResizeObserver(resize).observe(element);
  onThemeChange(paint);
  resize();
  paint();
  showLayers();
  viewer.choose(cameraNames(scene)[0], centreNow());

  return {
    show,
    draw,
    setLayer(name, visible) {
      layers[name] = visible;
      showLayers();
    },
    hasLayer: (name) => (name === "tracks" ? tracks !== null : name === "ground" ? ground !== null
      : name === "links" ? links.length > 0 : name === "joints" ? joints.length > 0
        : name === "hulls" ? bodies.some((body) => body.children.some((child) => child.userData.layer === "hulls")) : true),
    chooseCamera(name) {
      viewer.choose(name, centreNow());
      isStale = true;
    },
    /** Follows another body, -1 for the whole model. */
    followBody(body) {
      followBody(body);
      viewer.choose(viewer.mode(), centreNow());
      isStale = true;
    },
    orbit(...steps) {
      viewer.orbit(...steps);
      isStale = true;
    },
    showAnimation(next) {
      shown = next;
      isStale = true;
    },
    /** Where the camera stands, for tests. */
    cameraPlace: () => viewer.camera.position.toArray(),
    close() {
      dispose(world);
      renderer.dispose();
    },
  };
}
