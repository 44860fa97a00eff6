// SPDX-License-Identifier: MIT
// Drawing on the field: the transformation to pixels, robots, particles, detections, path.
import { wrapped } from "../format.js";
import { drawHollow, isHollow, outlineOf } from "./fits.js";
import { palette, themeColor } from "./palette.js";
import { extentOf } from "./scene.js";

const PATH = 10; // s
const BESIDE_GOAL = 1.2; // m
const DEFAULT_EXTENT = { x: 5.2, y: 3.7 }; // m, until the field is known
const extents = new WeakMap();

const extent = (scene) => {
  if (!extents.has(scene)) extents.set(scene, extentOf(scene));
  return extents.get(scene);
};

export const mirrored = ({ x, y, rotation }) => ({ x: -x, y: -y, rotation: wrapped(rotation + Math.PI) });

/// The transformation from the field to a box of pixels. A tall box shows the field upright, with the opponents' goal
/// at the top.
export function fieldPlan(field, wall, width, height) {
  const half = { ...(field ? extent(field) : DEFAULT_EXTENT) };
  if (wall) {
    const around = extent(wall);
    half.x = Math.max(half.x, around.x * 1.22);
    half.y = Math.max(half.y, around.y * 1.22);
  }
  const upright = height > width * 1.05;
  const margin = 6;
  const [across, along] = upright ? [half.y, half.x] : [half.x, half.y];
  const scale = Math.max(1, Math.min((width - 2 * margin) / (2 * across), (height - 2 * margin) / (2 * along)));
  const [u0, v0] = [width / 2, height / 2];
  const at = upright ? (x, y) => [u0 - scale * y, v0 - scale * x] : (x, y) => [u0 + scale * x, v0 - scale * y];
  const meters = upright
    ? (u, v) => [(v0 - v) / scale, (u0 - u) / scale]
    : (u, v) => [(u - u0) / scale, (v0 - v) / scale];
  const turn = upright ? Math.PI / 2 : 0;
  const labels = (context, scene) => {
    if (!scene) return;
    context.font = "600 11px system-ui, sans-serif";
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillStyle = "rgba(255, 255, 255, 0.85)";
    const widths = scene.labels.map(({ text }) => context.measureText(`${text} goal`).width);
    const longest = BESIDE_GOAL + Math.max(...widths) / scale;
    for (const { x, text } of scene.labels) {
      // On the border, beside the goal.
      const name = `${text} goal`;
      const long = context.measureText(name).width / scale;
      if (longest > extent(scene).y) continue;
      const [u, v] = at(Math.sign(x) * (Math.abs(x) - 0.35), BESIDE_GOAL + long / 2);
      context.save();
      context.translate(u, v);
      if (!upright) context.rotate(x > 0 ? Math.PI / 2 : -Math.PI / 2);
      context.fillText(name, 0, 0);
      context.restore();
    }
  };
  return { at, meters, scale, turn, labels };
}

/// The part of the field that the upper camera sees, from its calibration.
export function drawCone(context, { pose, headYaw }, calibration, plan) {
  const isPinhole = calibration && calibration.distortion_model !== "equidistant" && calibration.K[0] > 0;
  const half = isPinhole ? Math.atan(calibration.width / 2 / calibration.K[0]) : 0.5;
  const [u, v] = plan.at(pose.x, pose.y);
  const middle = -(pose.rotation + headYaw + plan.turn);
  const reach = 2.2 * plan.scale;
  const fading = context.createRadialGradient(u, v, 0, u, v, reach);
  fading.addColorStop(0, "rgba(150, 185, 255, 0.75)");
  fading.addColorStop(1, "rgba(150, 185, 255, 0.1)");
  context.beginPath();
  context.moveTo(u, v);
  context.arc(u, v, reach, middle - half, middle + half);
  context.closePath();
  context.fillStyle = fading;
  context.fill();
  context.lineWidth = 1;
  context.strokeStyle = "rgba(205, 222, 255, 0.9)";
  context.stroke();
}

export function drawParticles(context, { poses }, plan) {
  context.strokeStyle = palette.particle;
  context.fillStyle = palette.particle;
  context.lineWidth = 1.5;
  for (const { position, orientation } of poses) {
    const [u, v] = plan.at(position.x, position.y);
    const angle = -(2 * Math.atan2(orientation.z, orientation.w) + plan.turn);
    context.beginPath();
    context.arc(u, v, 2.2, 0, 2 * Math.PI);
    context.fill();
    context.beginPath();
    context.moveTo(u, v);
    context.lineTo(u + 8 * Math.cos(angle), v + 8 * Math.sin(angle));
    context.stroke();
  }
}

/// Detections, which are relative to the robot, at its believed pose.
export function drawPercepts(context, scene, pose, plan) {
  const cos = Math.cos(pose.rotation);
  const sin = Math.sin(pose.rotation);
  const at = (x, y) => plan.at(pose.x + cos * x - sin * y, pose.y + sin * x + cos * y);
  const hollow = [];
  for (const { points, color, closed } of scene.lines) {
    if (isHollow(color)) {
      const [from, to] = [points[0], points[points.length - 1]];
      const [u, v] = at((from.x + to.x) / 2, (from.y + to.y) / 2);
      hollow.push({ u, v, color });
      continue;
    }
    context.beginPath();
    points.forEach(({ x, y }, i) => (i ? context.lineTo(...at(x, y)) : context.moveTo(...at(x, y))));
    if (closed) context.closePath();
    context.strokeStyle = color;
    context.lineWidth = 1.5;
    context.stroke();
  }
  drawHollow(context, hollow);
  for (const { x, y, radius, color } of scene.circles) {
    const [u, v] = at(x, y);
    context.beginPath();
    context.arc(u, v, Math.max(4, radius * plan.scale), 0, 2 * Math.PI);
    if (!isHollow(color)) {
      context.fillStyle = color;
      context.fill();
    }
    context.lineWidth = isHollow(color) ? 2 : 1.5;
    context.strokeStyle = isHollow(color) ? outlineOf(color) : "#fff";
    context.stroke();
  }
}

export function drawPath(context, store, plan) {
  const index = store.shownIndex();
  const { frames } = store;
  const from = frames[index].time - PATH;
  context.beginPath();
  let before = null;
  for (let i = index; i >= 0 && frames[i].time >= from; --i) {
    const { pose } = frames[i];
    if (!pose) continue;
    const [u, v] = plan.at(pose.x, pose.y);
    // A flip or a placement is no movement.
    if (before && Math.hypot(before.x - pose.x, before.y - pose.y) < 0.5) context.lineTo(u, v);
    else context.moveTo(u, v);
    before = pose;
  }
  context.lineWidth = 2.5;
  context.lineJoin = "round";
  context.strokeStyle = "rgba(205, 222, 255, 0.85)";
  context.stroke();
}

/// A text in the middle of an empty drawing.
export function drawNote(context, text, width, height) {
  context.font = "14px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillStyle = themeColor("soft");
  context.fillText(text, width / 2, height / 2);
}
