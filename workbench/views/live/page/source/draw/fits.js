// SPDX-License-Identifier: MIT
// Detections that the pose filter rejects at the believed pose, or does not use: their messages are translucent, and
// the page draws them hollow.
const OPAQUE = 0.5; // opacity at which a detection is matched, or its fit is unknown
const UNUSED = 0.25; // opacity below which the filter does not use a detection
const RADIUS = 3; // pixels
const APART = 8; // pixels between two hollow marks, which would look like a solid line if they overlapped

/// `color`: of a scene, "rgba(r, g, b, a)".
const opacityOf = (color) => Number(color.slice(color.lastIndexOf(",") + 1, -1));
export const isHollow = (color) => opacityOf(color) < OPAQUE;

/// The same color, opaque if the detection is rejected, pale if it is not used.
export const outlineOf = (color) =>
  `${color.slice(0, color.lastIndexOf(","))}, ${opacityOf(color) < UNUSED ? 0.45 : 1})`;

/// Draws hollow marks for line points: [{u, v, color}].
export function drawHollow(context, marks) {
  const drawn = [];
  context.lineWidth = 1.3;
  for (const { u, v, color } of marks) {
    if (drawn.some((other) => Math.hypot(other.u - u, other.v - v) < APART)) continue;
    drawn.push({ u, v });
    context.beginPath();
    context.arc(u, v, RADIUS, 0, 2 * Math.PI);
    context.strokeStyle = outlineOf(color);
    context.stroke();
  }
}
