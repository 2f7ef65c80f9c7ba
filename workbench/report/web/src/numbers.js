// Numbers: of a pose, and as people read them.

export const kPose = 7; // origin and quaternion x y z w

/** A value in a table: as short as its size allows. digits: that are significant. */
export function shortNumber(value, digits = 5) {
  if (value === null || value === undefined) return "";
  if (typeof value !== "number") return String(value);
  if (Number.isInteger(value) && Math.abs(value) < 1e6) return String(value);
  const size = Math.abs(value);
  return size < 1e-3 || size >= 1e6 ? value.toExponential(2) : Number(value.toPrecision(digits)).toString();
}

/** 1, 2 or 5 times a power of ten, at most `size`. */
export function niceStep(size) {
  const power = 10 ** Math.floor(Math.log10(size));
  const digit = size / power;
  return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

const kDegrees = 180 / Math.PI;

/** Factor and unit that show angles in degrees. */
export function inDegrees(unit) {
  if (/^rad(?![a-z])/.test(unit)) return { factor: kDegrees, unit: unit.replace("rad", "deg") };
  if (unit.endsWith("/rad")) return { factor: 1 / kDegrees, unit: unit.replace(/rad$/, "deg") };
  return { factor: 1, unit };
}
