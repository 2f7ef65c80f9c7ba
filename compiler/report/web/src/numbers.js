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
