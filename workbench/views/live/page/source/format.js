// SPDX-License-Identifier: MIT
// Numbers and times as text.

/// A number with `digits` places and a real minus sign.
export function fixed(number, digits) {
  if (typeof number !== "number" || !Number.isFinite(number)) return "–";
  const text = number.toFixed(digits);
  return Number(text) === 0 ? text.replace("-", "") : text.replace("-", "−");
}

export const meters = (value) => `${fixed(value, 2)} m`;
export const degrees = (radians) => `${fixed((180 / Math.PI) * radians, 1)}°`;
export const seconds = (value, digits = 2) => `${fixed(value, digits)} s`;

/// A short duration: 4.2 s, 3 min 20 s.
export function duration(value) {
  if (value < 60) return `${fixed(value, value < 10 ? 1 : 0)} s`;
  return `${Math.floor(value / 60)} min ${Math.floor(value % 60)} s`;
}

/// Any value of /world as text.
export function plain(value) {
  if (typeof value === "number")
    return Number.isInteger(value) ? fixed(value, 0) : fixed(value, Math.abs(value) >= 100 ? 1 : 3);
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (value === null || value === undefined) return "–";
  return String(value);
}

/// A value of a parameter, as it is entered.
export const entered = (value) => (typeof value === "number" ? String(Number(value.toPrecision(7))) : String(value));

/// The angle in (−π, π].
export function wrapped(angle) {
  const turned = angle % (2 * Math.PI);
  if (turned > Math.PI) return turned - 2 * Math.PI;
  return turned <= -Math.PI ? turned + 2 * Math.PI : turned;
}
