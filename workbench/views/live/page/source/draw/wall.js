// SPDX-License-Identifier: MIT
// The wall of the room as a ring around the field, or unrolled as a strip over the azimuth.
import { palette, themeColor } from "./palette.js";
import { barsOf, drawEvidence, tileAt } from "./tiles.js";

const RING = 0.2; // thickness of the ring, in radii of the wall
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
  wall.belief = barsOf(
    scene.lines.map(({ points: [foot, top] }) => ({ azimuth: Math.atan2(foot.y, foot.x), height: top.z - foot.z })),
  );
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

/// The tile of the ring at a pixel, or null.
export function tileOfRing(scene, plan, evidence, u, v) {
  const { radius } = wallOf(scene);
  const [x, y] = plan.meters(u, v);
  const row = Math.floor(((Math.hypot(x, y) / radius - 1) / RING) * evidence.rows);
  return tileAt(evidence, Math.atan2(y, x), row);
}

/// The tiles as a ring outside of the wall's circle, the lowest row inside, and the rods inside of it. `evidence`: of the
/// tiles, or null.
export function drawRing(context, scene, plan, evidence = null) {
  const { radius, tiles, belief, top } = wallOf(scene);
  const [u, v] = plan.at(0, 0);
  const lowest = Math.min(...tiles.map((tile) => tile.low));
  const at = (height) => plan.scale * radius * (1 + (RING * (height - lowest)) / (top - lowest));
  const angle = (azimuth) => -(azimuth + plan.turn);
  const trace = (tile) => {
    context.arc(u, v, at(tile.high), angle(tile.to), angle(tile.from));
    context.arc(u, v, at(tile.low), angle(tile.from), angle(tile.to), true);
    context.closePath();
  };
  for (const tile of tiles) {
    context.beginPath();
    trace(tile);
    context.fillStyle = tile.color;
    context.fill();
    context.lineWidth = 0.5;
    context.strokeStyle = themeColor("paper");
    context.stroke();
  }
  if (evidence) {
    tiles.forEach((tile, i) => {
      const middle = angle((tile.from + tile.to) / 2);
      const tall = at(tile.high) - at(tile.low);
      const wide = at(tile.low) * (tile.to - tile.from);
      const [x, y] = [u + at(tile.low) * Math.cos(middle), v + at(tile.low) * Math.sin(middle)];
      const around = 1.5 * Math.max(tall, wide);
      const box = [x - around, y - around, x + around, y + around];
      drawEvidence(context, evidence, i, () => trace(tile), Math.min(tall, wide), box);
    });
  }
  context.strokeStyle = palette.view;
  context.lineWidth = Math.max(2, 0.12 * plan.scale);
  for (const { azimuth, bar } of evidence?.belief ?? belief) {
    const [cos, sin] = [Math.cos(angle(azimuth)), Math.sin(angle(azimuth))];
    const foot = plan.scale * radius * 0.98;
    const inner = foot - 0.18 * plan.scale * radius * bar;
    context.beginPath();
    context.moveTo(u + foot * cos, v + foot * sin);
    context.lineTo(u + inner * cos, v + inner * sin);
    context.stroke();
  }
}
