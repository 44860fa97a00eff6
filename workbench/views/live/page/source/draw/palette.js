// SPDX-License-Identifier: MIT
// The colors of all views, with the same meaning everywhere (workbench/views/scene/color.h), and the colors of the
// page.

export const palette = {
  truth: "#ffb300",
  belief: "#1558d6",
  opposite: "#d43034",
  particle: "rgba(44, 50, 58, 0.62)",
  view: "#e000a8",
  unknownTile: "rgba(128, 128, 128, 0.15)",
  noEvidence: "#bec3c9",
};

/// The color of the style sheet for each status of the room: whether the confidences count, do not count, or do not
/// exist.
export const statusBands = {
  usable: "good-band",
  unlearned: "amber-band",
  symmetric: "amber-band",
  lost: "amber-band",
  fresh: "amber-band",
  off: "gray-band",
  resting: "gray-band",
};

/// The color of a message: components from 0 to 1.
export function css({ r, g, b, a }) {
  return `rgba(${Math.round(255 * r)}, ${Math.round(255 * g)}, ${Math.round(255 * b)}, ${a})`;
}

let cached = null;

/// The value of a color of the style sheet, such as "ink", in the current theme.
export function themeColor(name) {
  cached ??= new Map();
  let value = cached.get(name);
  if (value === undefined) {
    value = getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
    cached.set(name, value);
  }
  return value;
}

/// Forgets the colors, because the theme changed.
export function forgetThemeColors() {
  cached = null;
}
