// SPDX-License-Identifier: MIT
// The marks of the believed, the mirrored and the true pose: the same shapes in drawings and in legends. They differ in
// shape, and the true pose is a frame around the two others, so that each is seen where they coincide.
import { labelsOf } from "./pose_labels.js";
import { palette } from "./palette.js";

/// label: beside the mark, in the color `ink`; path: in radii of the mark, heading to the right; box: around it in a
/// legend, heading up; line: width of its outline in radii; reach: radii from the middle to the tip.
export const POSE_MARKS = {
  belief: {
    label: "believed",
    color: palette.belief,
    ink: "#1248b4",
    path: "M.73 .68A1 1 0 1 1 .73 -.68L2.1 0Z",
    box: "-1.3 -2.2 2.6 3.3",
    fill: palette.belief,
    line: 0,
    reach: 2.1,
  },
  mirrored: {
    label: "mirrored",
    color: palette.opposite,
    ink: "#b81d23",
    path: "M2.3 0L-1.3 1.35L-.55 0L-1.3 -1.35Z",
    box: "-1.7 -2.6 3.4 4.1",
    fill: "rgba(255, 255, 255, 0.8)",
    line: 0.36,
    reach: 2.3,
  },
  truth: {
    label: "true",
    color: palette.truth,
    ink: "#7d5000",
    fill: "transparent",
    path: "M1.9 -.9L3 0L1.9 .9V1.5Q1.9 1.9 1.5 1.9H-1.5Q-1.9 1.9 -1.9 1.5V-1.5Q-1.9 -1.9 -1.5 -1.9H1.5Q1.9 -1.9 1.9 -1.5Z",
    box: "-2.2 -3.3 4.4 5.5",
    line: 0.55,
    reach: 3,
  },
};

const RADIUS = 8; // pixels
const FONT = 11; // pixels
const ORDER = ["truth", "mirrored", "belief"]; // the last is drawn on top

/// The size of the marks in a drawing: larger on a screen for an audience.
export const markSize = (width, height) => Math.min(2.4, Math.max(1, Math.min(width, height) / 520));

/// Draws the mark of a pose. `size`: times the usual one; `isGhost`: where the robot will be.
export function drawPoseMark(context, kind, { x, y, rotation }, plan, size = 1, isGhost = false) {
  const { color, path, fill, line } = POSE_MARKS[kind];
  const radius = RADIUS * size;
  const shape = new Path2D(path);
  context.save();
  context.translate(...plan.at(x, y));
  context.rotate(-(rotation + plan.turn));
  context.scale(radius, radius);
  context.lineJoin = "round";
  if (isGhost) context.setLineDash([0.7, 0.5]);
  context.lineWidth = line + 0.45;
  context.strokeStyle = "#fff";
  context.stroke(shape);
  context.fillStyle = fill;
  context.fill(shape);
  if (line) {
    context.lineWidth = line;
    context.strokeStyle = color;
    context.stroke(shape);
  }
  context.restore();
}

/// Draws the marks of several poses, {kind: pose}, with their labels.
export function drawPoses(context, poses, plan, width, height) {
  const size = markSize(width, height);
  const shown = ORDER.filter((kind) => poses[kind]);
  for (const kind of shown) drawPoseMark(context, kind, poses[kind], plan, size);
  context.save();
  context.font = `600 ${FONT * size}px system-ui, sans-serif`;
  context.textAlign = "left";
  context.textBaseline = "middle";
  const marks = [...shown].reverse().map((kind) => {
    const [u, v] = plan.at(poses[kind].x, poses[kind].y);
    const { label, ink, reach } = POSE_MARKS[kind];
    return { u, v, text: label, ink, reach: reach * RADIUS * size };
  });
  const measure = (text) => context.measureText(text).width;
  for (const { left, top, wide, tall, parts } of labelsOf(marks, measure, FONT * size, width, height)) {
    context.beginPath();
    context.roundRect(left, top, wide, tall, 3 * size);
    context.fillStyle = "rgba(255, 255, 255, 0.9)";
    context.fill();
    for (const { text, at, ink } of parts) {
      context.fillStyle = ink;
      context.fillText(text, at, top + tall / 2);
    }
  }
  context.restore();
}

/// The mark in a legend, heading up.
export function PoseMark({ kind }) {
  const { color, path, fill, line, box } = POSE_MARKS[kind];
  return (
    <svg class="pose-mark" viewBox={box} aria-hidden="true">
      <path d={path} transform="rotate(-90)" fill={fill} stroke={color} stroke-width={line} stroke-linejoin="round" />
    </svg>
  );
}
