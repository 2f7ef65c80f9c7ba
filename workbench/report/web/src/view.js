// The animation: a world in three.js, drawn for the player's time when something has changed.

import { Color, Fog, PCFShadowMap, WebGLRenderer } from "three";
import { cameraNames, createCamera } from "./camera.js";
import { createNames } from "./names.js";
import { poseBodies, poseForCamera } from "./poses.js";
import { createTarget } from "./target.js";
import { colour, onThemeChange } from "./theme.js";
import { createWorld } from "./world.js";

function createRenderer(element) {
  const renderer = new WebGLRenderer({ antialias: true });
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
  element.append(renderer.domElement);
  return renderer;
}

/** Colours of the page on everything that is not of a body. */
function paint(world, size) {
  const colours = { ground: colour("ground"), grid: colour("grid"), road: colour("road"), track: colour("track"), course: colour("course") };
  world.scene.background = new Color(colour("sky"));
  world.scene.fog = new Fog(colour("sky"), 3.2 * size, 9 * size);
  world.ground?.paint(colours);
  world.roads?.paint(colours);
  world.tracks?.paint(colours);
  world.course?.paint(colours);
}

/** table and others: of a result; undefined of modes. */
export function createView(scene, animation, element, table, others) {
  const renderer = createRenderer(element);
  const world = createWorld(scene, animation, table, others);
  const names = createNames(scene, world.bodies, element);
  const target = createTarget(scene, world.bodies);
  const viewer = createCamera(scene, renderer.domElement, target);
  let shown = animation;
  let time = animation.start;
  let isStale = true;

  /** Does something, and has the picture drawn anew. */
  const changing = (action) => (...parts) => {
    action(...parts);
    isStale = true;
  };

  /** The camera's target at the time shown. */
  function centre() {
    poseForCamera(world.bodies, shown, time);
    const place = target.centre();
    poseBodies(world.bodies, shown, time);
    return place;
  }

  function resize() {
    const { clientWidth, clientHeight } = element;
    if (clientWidth === 0 || clientHeight === 0) return;
    renderer.setSize(clientWidth, clientHeight);
    viewer.camera.aspect = clientWidth / clientHeight;
    viewer.camera.updateProjectionMatrix();
  }

  function draw() {
    if (!isStale) return;
    world.pose(shown, time);
    const place = centre();
    viewer.follow(place);
    world.ground?.follow(viewer.controls.target);
    world.lights.aim(place, target.heading);
    renderer.render(world.scene, viewer.camera);
    names.place(viewer.camera);
    isStale = false; // following moves the camera, which says that it changed
  }

  viewer.controls.addEventListener("change", changing(() => {}));
  new ResizeObserver(changing(resize)).observe(element);
  onThemeChange(changing(() => paint(world, scene.size)));
  resize();
  paint(world, scene.size);
  viewer.choose(cameraNames(scene)[0], centre());

  return {
    draw,
    show: changing((at) => {
      time = at;
    }),
    hasLayer: (name) => name === "names" || world.layers[name].length > 0,
    setLayer: changing((name, isShown) => {
      if (name === "names") names.show(isShown);
      else world.layers[name].forEach((object) => {
        object.visible = isShown;
      });
    }),
    /** Shows or hides one body with the marks of its joints, whatever the layers say. */
    showBody: changing((body, isShown) => {
      world.bodies[body].visible = isShown;
    }),
    chooseCamera: changing((name) => viewer.choose(name, centre())),
    /** Follows another body, -1 for the whole model. */
    followBody: changing((body) => {
      target.choose(body);
      viewer.choose(viewer.mode(), centre());
    }),
    orbit: changing(viewer.orbit),
    showAnimation: changing((next) => {
      shown = next;
    }),
    /** Where the camera stands, and where a link's ends are in the picture drawn last, for tests. */
    cameraPlace: () => viewer.camera.position.toArray(),
    drawnForces: () => world.drawnForces(),
    drawnCourse: () => world.course?.drawn ?? null,
    ghostPlace: (ghost, body) => world.ghosts.place(ghost, body),
    drawnRoads: () => world.roads?.drawn() ?? [],
    endPlaces: (link) => world.endPlaces(link).map((end) => end.toArray()),
  };
}
