// Names of the bodies over the picture.

import { Vector3 } from "three";

export function createNames(scene, bodies, element) {
  const layer = document.createElement("div");
  layer.className = "names";
  layer.hidden = true;
  element.append(layer);
  const labels = scene.bodies.flatMap(({ name, shapes }, index) => {
    if (shapes.length === 0) return [];
    const text = Object.assign(document.createElement("span"), { textContent: name });
    layer.append(text);
    const [shape] = shapes;
    const at = shape.at ?? shape.from.map((x, i) => (x + shape.to[i]) / 2);
    return [{ text, at: new Vector3(...at), body: bodies[index] }];
  });
  const place = new Vector3();
  return {
    show(isShown) {
      layer.hidden = !isShown;
    },
    place(camera) {
      if (layer.hidden) return;
      const { clientWidth, clientHeight } = element;
      labels.forEach(({ text, at, body }) => {
        place.copy(at).applyQuaternion(body.quaternion).add(body.position).project(camera);
        const x = ((place.x + 1) / 2) * clientWidth;
        const y = ((1 - place.y) / 2) * clientHeight;
        text.hidden = place.z > 1;
        text.style.transform = `translate(${x}px, ${y}px) translate(-50%, -50%)`;
      });
    },
  };
}
