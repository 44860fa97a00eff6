// SPDX-License-Identifier: MIT
// A foxglove.SceneUpdate as polygons, lines, circles and labels, and their drawing as seen from above.
import { css } from "./palette.js";

const scenes = new WeakMap();

/// The polygons of a mesh whose triangles are fans: {color, points}.
function polygonsOf({ points, colors, indices }) {
  const polygons = [];
  let fan = null;
  for (let i = 0; i + 2 < indices.length; i += 3) {
    const [first, second, third] = [indices[i], indices[i + 1], indices[i + 2]];
    if (fan && fan.first === first && fan.last === second) {
      fan.points.push(points[third]);
    } else {
      fan = { first, color: css(colors[first]), points: [points[first], points[second], points[third]] };
      polygons.push(fan);
    }
    fan.last = third;
  }
  return polygons;
}

function polylinesOf({ type, points, color, thickness }) {
  const style = { color: css(color), thickness };
  if (type !== 2) return [{ ...style, points, closed: type === 1 }];
  const lines = [];
  for (let i = 0; i + 1 < points.length; i += 2)
    lines.push({ ...style, points: [points[i], points[i + 1]], closed: false });
  return lines;
}

/// The contents of a scene message; computed once a message.
export function sceneOf(message) {
  let scene = scenes.get(message);
  if (!scene) {
    scene = { polygons: [], lines: [], circles: [], labels: [] };
    for (const entity of message.entities) {
      for (const mesh of entity.triangles) scene.polygons.push(...polygonsOf(mesh));
      for (const line of entity.lines) scene.lines.push(...polylinesOf(line));
      for (const { pose, size, color } of entity.cylinders)
        scene.circles.push({ x: pose.position.x, y: pose.position.y, radius: size.x / 2, color: css(color) });
      for (const { pose, text, color } of entity.texts)
        scene.labels.push({ x: pose.position.x, y: pose.position.y, text, color: css(color) });
    }
    scenes.set(message, scene);
  }
  return scene;
}

function trace(context, points, at, closed) {
  context.beginPath();
  points.forEach((point, i) => {
    const [x, y] = at(point.x, point.y);
    if (i === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  });
  if (closed) context.closePath();
}

/// Draws a scene. `at(x, y)`: the pixel of a point in meters; `scale`: pixels in a meter; `thinnest`: pixels.
export function drawScene(context, scene, at, scale, { thinnest = 1, smallest = 2.5 } = {}) {
  for (const { points, color } of scene.polygons) {
    trace(context, points, at, true);
    context.fillStyle = color;
    context.fill();
  }
  context.lineJoin = "round";
  for (const { points, color, thickness, closed } of scene.lines) {
    trace(context, points, at, closed);
    context.strokeStyle = color;
    context.lineWidth = Math.max(thinnest, thickness * scale);
    context.stroke();
  }
  for (const { x, y, radius, color } of scene.circles) {
    const [u, v] = at(x, y);
    context.beginPath();
    context.arc(u, v, Math.max(smallest, radius * scale), 0, 2 * Math.PI);
    context.fillStyle = color;
    context.fill();
  }
}

/// The largest distance of a point from the axes: {x, y} in meters.
export function extentOf(scene) {
  let x = 0;
  let y = 0;
  for (const { points } of [...scene.polygons, ...scene.lines]) {
    for (const point of points) {
      x = Math.max(x, Math.abs(point.x));
      y = Math.max(y, Math.abs(point.y));
    }
  }
  return { x, y };
}
