// Roads as strips along the way of the wheels: heights, lines of a grid, and friction as a colour.

import {
  BufferAttribute, BufferGeometry, CanvasTexture, Color, DoubleSide, Group, Mesh, MeshStandardMaterial, RepeatWrapping,
  SRGBColorSpace,
} from "three";
import { niceStep } from "./numbers.js";

const kStation = 4; // numbers: x, y, cosine and sine of the direction
const kSeenSlope = 0.25; // that the light takes the usual slope of a strip for: unevenness of millimetres is to be seen
const kMostSteep = 25; // times as steep
const kSlippery = new Color("#2f7fff");
const kGrippy = new Color("#ff8a3c");
const kPixels = 128; // of a cell of the grid

/** A cell of the grid with its lines, white where the ground keeps its colour. */
function gridTexture() {
  const canvas = Object.assign(document.createElement("canvas"), { width: kPixels, height: kPixels });
  const pen = canvas.getContext("2d");
  pen.fillStyle = "#fff";
  pen.fillRect(0, 0, kPixels, kPixels);
  pen.fillStyle = "#8f979f";
  pen.fillRect(0, 0, kPixels, 2);
  pen.fillRect(0, 0, 2, kPixels);
  const texture = new CanvasTexture(canvas);
  texture.wrapS = RepeatWrapping;
  texture.wrapT = RepeatWrapping;
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = 16;
  return texture;
}

/** White for the tyre's own friction, blue for less, orange for more. */
function frictionColour(factor, colour) {
  const share = Math.min(1, Math.abs(1 - factor));
  return colour.set("#fff").lerp(factor < 1 ? kSlippery : kGrippy, 0.75 * share);
}

/** From the station before to one, m; at: of its numbers. */
function stationStep(stations, at) {
  return Math.hypot(stations[at] - stations[at - kStation], stations[at + 1] - stations[at + 1 - kStation]);
}

/** Places of a strip. steeper: heights times that. */
function places({ stations, offsets, heights }, steeper) {
  const numbers = new Float32Array(3 * heights.length);
  heights.forEach((height, i) => {
    const station = Math.floor(i / offsets.length) * kStation;
    const offset = offsets[i % offsets.length];
    const [x, y, cosine, sine] = stations.subarray(station, station + kStation);
    numbers.set([x - offset * sine, y + offset * cosine, steeper * height], 3 * i);
  });
  return new BufferAttribute(numbers, 3);
}

/** How much steeper than they are the light sees the slopes along a strip. */
function steepness({ stations, offsets, heights }) {
  let squares = 0;
  let length = 0;
  for (let i = offsets.length; i < heights.length; ++i) {
    const station = Math.floor(i / offsets.length) * kStation;
    const step = stationStep(stations, station);
    if (!(step > 0)) continue;
    squares += (heights[i] - heights[i - offsets.length]) ** 2 / step;
    length += step;
  }
  return Math.min(kMostSteep, Math.max(1, kSeenSlope / Math.sqrt(squares / length)));
}

/** Metres along the way and across it, in cells. */
function cells({ stations, offsets, heights }, step) {
  const numbers = new Float32Array(2 * heights.length);
  let along = 0;
  for (let row = 0; row * offsets.length < heights.length; ++row) {
    const at = row * kStation;
    if (row > 0) along += stationStep(stations, at);
    offsets.forEach((offset, k) => numbers.set([along / step, offset / step], 2 * (row * offsets.length + k)));
  }
  return new BufferAttribute(numbers, 2);
}

function triangles({ offsets, heights }) {
  const width = offsets.length;
  const corners = [];
  for (let right = 0; right + width + 1 < heights.length; ++right) {
    if (right % width === width - 1) continue;
    const ahead = right + width;
    corners.push(right, ahead, ahead + 1, right, ahead + 1, right + 1);
  }
  return corners;
}

function stripGeometry(strip, step) {
  const geometry = new BufferGeometry();
  geometry.setIndex(triangles(strip));
  geometry.setAttribute("position", places(strip, steepness(strip)));
  geometry.computeVertexNormals();
  geometry.setAttribute("position", places(strip, 1));
  geometry.setAttribute("uv", cells(strip, step));
  if (strip.friction) {
    const colour = new Color();
    const colours = new Float32Array(3 * strip.heights.length);
    strip.friction.forEach((factor, i) => frictionColour(factor, colour).toArray(colours, 3 * i));
    geometry.setAttribute("color", new BufferAttribute(colours, 3));
  }
  return geometry;
}

/** The strips of a scene's roads. */
export function createRoads(scene) {
  const group = new Group();
  const step = niceStep(scene.size / 8);
  const texture = gridTexture();
  scene.ground.strips.forEach((strip) => {
    const surface = new MeshStandardMaterial({
      roughness: 1, metalness: 0, side: DoubleSide, map: texture, vertexColors: Boolean(strip.friction),
    });
    const mesh = new Mesh(stripGeometry(strip, step), surface);
    mesh.receiveShadow = true;
    group.add(mesh);
  });
  return {
    group,
    paint: (colours) => group.children.forEach((mesh) => mesh.material.color.set(colours.road)),
    /** Triangles, and the lowest and highest place, m, of each strip, for tests. */
    drawn: () => group.children.map(({ geometry }) => {
      geometry.computeBoundingBox();
      const { min, max } = geometry.boundingBox;
      return { triangles: geometry.index.count / 3, lowest: min.z, highest: max.z };
    }),
  };
}
