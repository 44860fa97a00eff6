// SPDX-License-Identifier: MIT
// The wall of the room as a ring around the field, or unrolled as a strip over the azimuth.
import { palette, themeColor } from "./palette.js";

const RING = 0.2; // thickness of the ring, in radii of the wall
const walls = new WeakMap();

/// {radius, tiles: [{from, to, low, high, color}], rods: [{azimuth, height}], top} of a wall scene; angles in rad,
/// heights in m.
export function wallOf(scene) {
  let wall = walls.get(scene);
  if (wall) return wall;
  wall = { radius: 1, tiles: [], rods: [], top: 1 };
  for (const { points, color } of scene.polygons) {
    const azimuths = points.map(({ x, y }) => Math.atan2(y, x));
    const heights = points.map(({ z }) => z);
    let [from, to] = [Math.min(...azimuths), Math.max(...azimuths)];
    if (to - from > Math.PI) [from, to] = [to, from + 2 * Math.PI]; // across the direction of the own goal
    wall.tiles.push({ from, to, low: Math.min(...heights), high: Math.max(...heights), color });
    wall.radius = Math.hypot(points[0].x, points[0].y);
  }
  wall.top = Math.max(1, ...wall.tiles.map((tile) => tile.high));
  for (const { points } of scene.lines)
    wall.rods.push({ azimuth: Math.atan2(points[0].y, points[0].x), height: points[1].z - points[0].z });
  walls.set(scene, wall);
  return wall;
}

/// Where the line of sight of a robot meets the wall: azimuth in rad.
export function sightOnWall({ x, y, rotation }, headYaw, radius) {
  const angle = rotation + headYaw;
  const [dx, dy] = [Math.cos(angle), Math.sin(angle)];
  const along = x * dx + y * dy;
  const reach = -along + Math.sqrt(Math.max(0, along * along - (x * x + y * y) + radius * radius));
  return Math.atan2(y + reach * dy, x + reach * dx);
}

/// The tiles as a ring outside of the wall's circle, the lowest row inside, and the rods inside of it.
export function drawRing(context, scene, plan) {
  const { radius, tiles, rods, top } = wallOf(scene);
  const [u, v] = plan.at(0, 0);
  const lowest = Math.min(...tiles.map((tile) => tile.low));
  const at = (height) => plan.scale * radius * (1 + (RING * (height - lowest)) / (top - lowest));
  const angle = (azimuth) => -(azimuth + plan.turn);
  for (const tile of tiles) {
    context.beginPath();
    context.arc(u, v, at(tile.high), angle(tile.to), angle(tile.from));
    context.arc(u, v, at(tile.low), angle(tile.from), angle(tile.to), true);
    context.closePath();
    context.fillStyle = tile.color;
    context.fill();
    context.lineWidth = 0.5;
    context.strokeStyle = themeColor("paper");
    context.stroke();
  }
  const tallest = Math.max(0.01, ...rods.map((rod) => rod.height));
  context.strokeStyle = palette.view;
  context.lineWidth = Math.max(2, 0.12 * plan.scale);
  for (const { azimuth, height } of rods) {
    const [cos, sin] = [Math.cos(angle(azimuth)), Math.sin(angle(azimuth))];
    const outer = plan.scale * radius * 0.98;
    const inner = outer - (0.16 * plan.scale * radius * height) / tallest;
    context.beginPath();
    context.moveTo(u + outer * cos, v + outer * sin);
    context.lineTo(u + inner * cos, v + inner * sin);
    context.stroke();
  }
}
