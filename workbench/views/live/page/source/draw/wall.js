// SPDX-License-Identifier: MIT
// The wall of the room as a ring around the field, or unrolled as a strip over the azimuth.
import { wrapped } from "../format.js";
import { palette, themeColor } from "./palette.js";

const RING = 0.2; // thickness of the ring, in radii of the wall
const NEAR = 0.03; // rad, less than a cell of a grid and more than the distance of particles
const FULL = 0.3; // fraction of the belief at which a bar is highest
const walls = new WeakMap();

/// {radius, tiles: [{from, to, low, high, color}], belief: [{azimuth, bar}], top} of a wall scene: angles in rad,
/// heights in m, the bars of the belief of the view from 0 to 1.
export function wallOf(scene) {
  let wall = walls.get(scene);
  if (wall) return wall;
  wall = { radius: 1, tiles: [], belief: [], top: 1 };
  for (const { points, color } of scene.polygons) {
    const azimuths = points.map(({ x, y }) => Math.atan2(y, x));
    const heights = points.map(({ z }) => z);
    let [from, to] = [Math.min(...azimuths), Math.max(...azimuths)];
    if (to - from > Math.PI) [from, to] = [to, from + 2 * Math.PI]; // across the direction of the own goal
    wall.tiles.push({ from, to, low: Math.min(...heights), high: Math.max(...heights), color });
    wall.radius = Math.hypot(points[0].x, points[0].y);
  }
  wall.top = Math.max(1, ...wall.tiles.map((tile) => tile.high));
  wall.belief = beliefOf(scene.lines);
  walls.set(scene, wall);
  return wall;
}

/// The rods of a grid or of particles as bars over the azimuth. The height of a bar is the root of the fraction of the
/// belief around its azimuth, so that a uniform belief has low bars.
function beliefOf(rods) {
  const all = rods.map(({ points: [foot, top] }) => ({ azimuth: Math.atan2(foot.y, foot.x), height: top.z - foot.z }));
  const sum = all.reduce((total, { height }) => total + height, 0);
  return all.map(({ azimuth }) => {
    let around = 0;
    for (const other of all) if (Math.abs(wrapped(other.azimuth - azimuth)) < NEAR) around += other.height;
    return { azimuth, bar: Math.min(1, Math.sqrt(around / sum / FULL)) };
  });
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
  const { radius, tiles, belief, top } = wallOf(scene);
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
  context.strokeStyle = palette.view;
  context.lineWidth = Math.max(2, 0.12 * plan.scale);
  for (const { azimuth, bar } of belief) {
    const [cos, sin] = [Math.cos(angle(azimuth)), Math.sin(angle(azimuth))];
    const outer = plan.scale * radius * 0.98;
    const inner = outer - 0.18 * plan.scale * radius * bar;
    context.beginPath();
    context.moveTo(u + outer * cos, v + outer * sin);
    context.lineTo(u + inner * cos, v + inner * sin);
    context.stroke();
  }
}
