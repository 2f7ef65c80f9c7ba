// Sun and sky.

import { AmbientLight, DirectionalLight, HemisphereLight, Vector3 } from "three";

/** The sun stands behind and beside what it lights, and its shadows reach as far as the scene is large. */
export function createLights(scene) {
  const up = new Vector3(...scene.up);
  const sun = new DirectionalLight("#ffffff", 2.2);
  sun.castShadow = true;
  sun.shadow.mapSize.set(2048, 2048);
  sun.shadow.radius = 3;
  sun.shadow.bias = -0.0006;
  const lit = 0.8 * scene.size;
  Object.assign(sun.shadow.camera, {
    left: -lit, right: lit, top: lit, bottom: -lit, near: 0.05 * scene.size, far: 6 * scene.size,
  });
  const sky = new HemisphereLight("#ffffff", "#8a8f96", 1.35);
  sky.position.copy(up);
  const side = new Vector3();
  return {
    objects: [sun, sun.target, sky, new AmbientLight("#ffffff", 0.25)],
    aim(centre, heading) {
      side.crossVectors(up, heading);
      sun.target.position.copy(centre);
      sun.position.copy(centre).addScaledVector(up, 2 * scene.size).addScaledVector(heading, 0.7 * scene.size)
        .addScaledVector(side, 0.9 * scene.size);
    },
  };
}
