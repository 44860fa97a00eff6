// SPDX-License-Identifier: MIT
// The wall of the room: tiles in their mean color, framed by the pose that they match, where the robot looks, and the
// view belief over the azimuth.
import { useRef } from "preact/hooks";

import { Canvas } from "../draw/canvas.jsx";
import { markText, positionOf } from "../draw/evidence_scale.js";
import { drawNote, fieldPlan, mirrored } from "../draw/field.js";
import { palette, themeColor } from "../draw/palette.js";
import { POSE_MARKS, drawPoseMark } from "../draw/pose_marks.jsx";
import { sceneOf } from "../draw/scene.js";
import { drawEvidence, evidenceColor, factsOf, tileAt } from "../draw/tiles.js";
import { drawRing, sightOnWall, tileOfRing, wallOf } from "../draw/wall.js";
import { fixed, seconds } from "../format.js";
import { limits, store } from "../robot.js";
import { roomOf } from "../room.js";
import { set, settings } from "../settings.js";
import { changedByUser, useChanges } from "../ticker.js";

const BAR_END = 150; // log-odds
const BAR_MARKS = [-100, -10, -1, 0, 1, 10, 100];
const LEAST_RING = 150; // pixels, below which the ring is too small to read
const DIRECTIONS = [
  [180, "own goal"],
  [90, "left"],
  [0, "opponent's goal"],
  [-90, "right"],
  [-180, "own goal"],
];

/// Lines with labels at two positions. The labels do not overlap, if they fit at all.
function drawMarkers(context, markers, top, bottom, width) {
  context.font = "600 11px system-ui, sans-serif";
  context.textBaseline = "bottom";
  context.textAlign = "left";
  const [left, right] = [...markers].sort((some, other) => some.u - other.u);
  const wide = ({ name }) => context.measureText(name).width;
  right.label = Math.min(right.u - 6, width - 2 - wide(right));
  left.label = Math.max(2, Math.min(left.u - 6, right.label - 8 - wide(left)));
  right.label = Math.max(right.label, left.label + wide(left) + 8);
  for (const { u, color, name, label } of markers) {
    context.strokeStyle = context.fillStyle = color;
    context.lineWidth = 2.5;
    context.beginPath();
    context.moveTo(u, top);
    context.lineTo(u, bottom);
    context.stroke();
    context.beginPath();
    context.moveTo(u - 6, top - 1);
    context.lineTo(u + 6, top - 1);
    context.lineTo(u, top + 7);
    context.fill();
    context.fillText(name, label, top - 4);
  }
}

/// Draws the wall unrolled. Returns the function that finds the tile at a pixel.
function drawStrip(context, scene, evidence, frame, width, height) {
  const { radius, tiles, belief, top } = wallOf(scene);
  const [left, right, above, below] = [6, width - 6, 20, 17];
  // What is on the robot's left is on the left.
  const at = (azimuth) => left + ((Math.PI - azimuth) / (2 * Math.PI)) * (right - left);
  const bars = Math.max(12, 0.26 * (height - above - below));
  const [tilesTop, tilesBottom] = [above, height - below - bars - 4];
  const lowest = Math.min(...tiles.map((tile) => tile.low));
  const v = (z) => tilesBottom - ((z - lowest) / (top - lowest)) * (tilesBottom - tilesTop);
  tiles.forEach(({ from, to, low, high, color }, i) => {
    for (const turn of to > Math.PI ? [0, -2 * Math.PI] : [0]) {
      const [u1, u2] = [Math.max(left, at(to + turn)), Math.min(right, at(from + turn))];
      if (u2 <= u1) continue;
      const box = [u1 + 0.5, v(high) + 0.5, u2 - 0.5, v(low) - 0.5];
      const trace = () => context.rect(box[0], box[1], box[2] - box[0], box[3] - box[1]);
      context.fillStyle = color;
      context.fillRect(box[0], box[1], box[2] - box[0], box[3] - box[1]);
      if (evidence) drawEvidence(context, evidence, i, trace, Math.min(u2 - u1, v(low) - v(high)), box);
    }
  });
  const base = height - below;
  const wide = Math.max(2, (right - left) / 120);
  context.fillStyle = palette.view;
  for (const { azimuth, bar } of evidence?.belief ?? belief) {
    const tall = Math.max(1, bar * (bars - 2));
    context.fillRect(at(azimuth) - wide / 2, base - tall, wide, tall);
  }
  context.fillStyle = themeColor("rule");
  context.fillRect(left, base, right - left, 1);
  context.font = "11px system-ui, sans-serif";
  context.textBaseline = "top";
  context.fillStyle = themeColor("soft");
  for (const [angle, name] of DIRECTIONS) {
    context.textAlign = angle === 180 ? "left" : angle === -180 ? "right" : "center";
    context.fillText(name, at((angle * Math.PI) / 180), base + 4);
  }
  const tileOf = (u, v) => {
    const row = Math.floor(((tilesBottom - v) / (tilesBottom - tilesTop)) * evidence.rows);
    return tileAt(evidence, Math.PI - ((u - left) / (right - left)) * 2 * Math.PI, row);
  };
  if (!frame?.pose) return tileOf;
  const seen = at(sightOnWall(frame.pose, frame.headYaw, radius));
  const other = at(sightOnWall(mirrored(frame.pose), frame.headYaw, radius));
  const views = [
    { u: other, color: themeColor("mirrored"), name: "view if mirrored" },
    { u: seen, color: themeColor("belief"), name: "believed view" },
  ];
  drawMarkers(context, views, above, base, width);
  return tileOf;
}

/// The same for the wall as a ring.
function drawWallRing(context, scene, evidence, frame, width, height) {
  const plan = fieldPlan(null, scene, width, height);
  drawRing(context, scene, plan, evidence);
  const message = store.lasting.get("/field");
  if (message) {
    for (const { points, color } of sceneOf(message).polygons) {
      const corners = points.map(({ x, y }) => plan.at(x, y));
      context.beginPath();
      corners.forEach(([u, v], i) => (i ? context.lineTo(u, v) : context.moveTo(u, v)));
      context.fillStyle = color;
      context.fill();
    }
  }
  const tileOf = (u, v) => tileOfRing(scene, plan, evidence, u, v);
  if (!frame?.pose) return tileOf;
  const { radius } = wallOf(scene);
  for (const [kind, pose] of [
    ["mirrored", mirrored(frame.pose)],
    ["belief", frame.pose],
  ]) {
    const azimuth = sightOnWall(pose, frame.headYaw, radius);
    context.setLineDash([4, 4]);
    context.strokeStyle = POSE_MARKS[kind].color;
    context.lineWidth = 1.5;
    context.beginPath();
    context.moveTo(...plan.at(pose.x, pose.y));
    context.lineTo(...plan.at(radius * Math.cos(azimuth), radius * Math.sin(azimuth)));
    context.stroke();
    context.setLineDash([]);
    drawPoseMark(context, kind, pose, plan, 0.65);
  }
  return tileOf;
}

/// Draws the wall as a strip or as a ring. Returns the function that finds the tile at a pixel, if there is a wall.
export function drawWall(context, width, height, form) {
  const found = store.read("/wall", 60);
  if (!found) {
    drawNote(context, "The robot has not learned any colors of the room yet.", width, height);
    return null;
  }
  const draw = form === "ring" && height > LEAST_RING ? drawWallRing : drawStrip;
  // The belief of the view belongs to the frame of its message, and so do the views that it is compared with.
  const room = roomOf(store);
  const frame = room ?? store.frames[store.indexAt(found.time)];
  return draw(context, sceneOf(found.value), room?.tiles, frame, width, height);
}

/// The evidence as a bar from the believed to the mirrored pose, with the thresholds of a decision.
export function EvidenceBar() {
  useChanges(100);
  const frame = store.shown();
  const evidence = frame?.evidence;
  const known = typeof evidence === "number";
  const limit = limits();
  const place = (value) => 50 + 50 * positionOf(value, BAR_END);
  const from = known ? Math.min(50, place(evidence)) : 50;
  const to = known ? Math.max(50, place(evidence)) : 50;
  return (
    <div class="evidence">
      <span class="blue">believed</span>
      <div class="bar" role="img" aria-label={`Evidence ${fixed(evidence, 1)} on a logarithmic scale`}>
        {BAR_MARKS.map((mark) => (
          <small key={mark} class={Math.abs(mark) === 1 ? "fine" : undefined} style={{ left: `${place(mark)}%` }}>
            {markText(mark)}
          </small>
        ))}
        <i class={evidence > 0 ? "red" : "blue"} style={{ left: `${from}%`, width: `${to - from}%` }} />
        <b style={{ left: "50%" }} />
        {limit &&
          [limit.unconfirmed, -limit.unconfirmed].map((value) => (
            <u key={value} style={{ left: `${place(value)}%` }} />
          ))}
        {known && <em class={fixed(evidence, 1) === "0.0" ? "" : evidence > 0 ? "red" : "blue"} style={{ left: `${place(evidence)}%` }} />}
      </div>
      <span class="red">mirrored</span>
      <span class="value">
        {known ? fixed(evidence, 1) : "–"}
        <small>log scale</small>
      </span>
    </div>
  );
}

/// What the frames of the tiles mean. flip: the time of a flip since the tiles were compared, or null.
function TileLegend({ flip }) {
  return (
    <p class="tile-legend" title="A frame is thick while its tile is in view. A click on a tile shows its numbers.">
      Tiles match
      <i style={{ borderColor: evidenceColor(-1) }} /> believed
      <i style={{ borderColor: evidenceColor(0) }} /> neither
      <i class="striped" style={{ borderColor: evidenceColor(1), color: evidenceColor(1) }} /> mirrored
      {flip != null && (
        <span class="badge" title={`Compared before the flip at ${seconds(flip)}, and shown for the pose after it.`}>
          before the flip
        </span>
      )}
    </p>
  );
}

/// What is known about the tile that was clicked; otherwise the legend. A box would cover tiles.
function TileNumbers({ picked }) {
  useChanges(200);
  const room = roomOf(store);
  const tiles = room?.tiles;
  if (picked.current === null || !tiles) return <TileLegend flip={room?.flip} />;
  const close = () => {
    picked.current = null;
    changedByUser();
  };
  return (
    <div class="tile-numbers" role="status">
      {factsOf(tiles, picked.current).map((fact) => (
        <span key={fact}>{fact}</span>
      ))}
      <button class="plain" aria-label="Close the numbers" onClick={close}>
        ×
      </button>
    </div>
  );
}

function WallPanel() {
  useChanges(1000);
  const other = settings.wall === "ring" ? "strip" : "ring";
  const tileOf = useRef(null);
  const picked = useRef(null);
  const pick = (u, v) => {
    picked.current = (roomOf(store) && tileOf.current?.(u, v)) ?? null;
    changedByUser();
  };
  const draw = (context, width, height) => {
    tileOf.current = drawWall(context, width, height, settings.wall);
  };
  return (
    <div class="fill column">
      <div class="row tight">
        <EvidenceBar />
        <button class="chip ring-chip" onClick={() => set({ wall: other })}>
          Show as {other}
        </button>
      </div>
      <TileNumbers picked={picked} />
      <div class="stage">
        <Canvas
          draw={draw}
          interval={66}
          onPoint={pick}
          label="The wall of the room in the colors that the robot learned, and the tiles that match the believed pose"
        />
      </div>
    </div>
  );
}

export default { id: "wall", title: "Wall", area: "below", key: "2", Component: WallPanel };
