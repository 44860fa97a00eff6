// SPDX-License-Identifier: MIT
// The field from above: lines, goals, particles, believed, mirrored and true pose, detections, and the path.
import { useRef } from "preact/hooks";

import { Canvas } from "../draw/canvas.jsx";
import { drawCone, drawParticles, drawPath, drawPercepts, fieldPlan, mirrored } from "../draw/field.js";
import { palette } from "../draw/palette.js";
import { POSE_MARKS, PoseMark, drawPoses, markSize } from "../draw/pose_marks.jsx";
import { drawScene, sceneOf } from "../draw/scene.js";
import { drawRing } from "../draw/wall.js";
import { degrees, meters } from "../format.js";
import { store } from "../robot.js";
import { roomOf } from "../room.js";
import { set, settings } from "../settings.js";
import { changedByUser, useChanges } from "../ticker.js";
import { Carry } from "./carry.js";

const HINTS = {
  belief: "The believed pose: where the robot thinks it is.",
  cone: "The part of the field that the upper camera sees from the believed pose.",
  mirrored: "The mirrored pose: the believed pose rotated by 180 degrees about the center of the field.",
  truth: "The true pose: where the robot really is. The robot does not know it.",
  percepts: "Solid: matches the field at the believed pose. Hollow: rejected by the pose filter. Pale: not used by it.",
  ring: "Frames of the tiles: blue matches the believed pose, striped red the mirrored pose.",
};
const LAYERS = [
  ["belief", POSE_MARKS.belief.label],
  ["cone", "view", "#7fa3ec"],
  ["mirrored", POSE_MARKS.mirrored.label],
  ["truth", POSE_MARKS.truth.label],
  ["particles", "particles", "#5b626b"],
  ["percepts", "detections", "#00c2e8"],
  ["path", "path", "#86b3ff"],
  ["ring", "wall", palette.view],
];

/// Draws the field with the chosen layers. Returns the plan: the transformation from meters to pixels.
export function drawField(context, width, height, layers) {
  const message = store.lasting.get("/field");
  const wall = layers.ring ? store.read("/wall", 60) : null;
  const plan = fieldPlan(message && sceneOf(message), wall && sceneOf(wall.value), width, height);
  if (message) drawScene(context, sceneOf(message), plan.at, plan.scale);
  plan.labels(context, message && sceneOf(message));
  if (wall) drawRing(context, sceneOf(wall.value), plan, roomOf(store)?.tiles);
  const frame = store.shown();
  if (!frame?.pose) return plan;
  if (layers.path) drawPath(context, store, plan);
  const particles = layers.particles && store.read("/belief/particles", 2);
  if (particles) drawParticles(context, particles.value, plan);
  if (layers.cone) drawCone(context, frame, store.lasting.get("/camera/upper/calibration"), plan);
  const percepts = layers.percepts && store.read("/percepts", 0.5);
  if (percepts) drawPercepts(context, sceneOf(percepts.value), frame.pose, plan);
  const poses = {
    belief: layers.belief && frame.pose,
    mirrored: layers.mirrored && mirrored(frame.pose),
    truth: layers.truth && frame.truth,
  };
  drawPoses(context, poses, plan, width, height);
  return plan;
}

function numbersAt(plan, picked) {
  const frame = store.shown();
  if (!frame?.pose) return [`Point: x ${meters(picked.x)}, y ${meters(picked.y)}`];
  const poses = [
    ["Believed pose", frame.pose],
    ["Mirrored pose", mirrored(frame.pose)],
  ];
  if (frame.truth) poses.push(["True pose", frame.truth]);
  const near = poses.filter(([, pose]) => Math.hypot(pose.x - picked.x, pose.y - picked.y) * plan.scale < 18);
  if (near.length)
    return near.map(([name, { x, y, rotation }]) => `${name}: x ${meters(x)}, y ${meters(y)}, ${degrees(rotation)}`);
  const distance = Math.hypot(picked.x - frame.pose.x, picked.y - frame.pose.y);
  return [`Point: x ${meters(picked.x)}, y ${meters(picked.y)}, ${meters(distance)} from the believed pose`];
}

function Numbers({ plan, picked, carry }) {
  useChanges(100);
  const carried = carry.lines();
  if (carried.length)
    return (
      <div class="numbers" role="status">
        {carried.map((line) => (
          <div key={line}>{line}</div>
        ))}
      </div>
    );
  if (!picked.current || !plan.current) return null;
  return (
    <div class="numbers" role="status">
      {numbersAt(plan.current, picked.current).map((line) => (
        <div key={line}>{line}</div>
      ))}
      <button
        class="plain"
        aria-label="Close the numbers"
        onClick={() => {
          picked.current = null;
          changedByUser();
        }}
      >
        ×
      </button>
    </div>
  );
}

function Field() {
  const plan = useRef(null);
  const picked = useRef(null);
  const carry = useRef(null);
  carry.current ??= new Carry(plan);
  const draw = (context, width, height) => {
    plan.current = drawField(context, width, height, settings.layers);
    carry.current.draw(context, markSize(width, height));
    if (!picked.current) return;
    const [u, v] = plan.current.at(picked.current.x, picked.current.y);
    context.strokeStyle = "#fff";
    context.lineWidth = 1.5;
    context.strokeRect(u - 4, v - 4, 8, 8);
  };
  const pick = (u, v) => {
    if (carry.current.ended) return;
    const [x, y] = plan.current.meters(u, v);
    picked.current = { x, y };
    changedByUser();
  };
  return (
    <div class="fill column">
      <Layers />
      <div class="stage">
        <Canvas
          draw={draw}
          onPoint={pick}
          handlers={carry.current.handlers}
          label="The field from above, with the poses of the robot"
        />
        <Numbers plan={plan} picked={picked} carry={carry.current} />
      </div>
    </div>
  );
}

function Layers() {
  useChanges(500);
  const hasTruth = store.frames.some((frame) => frame.truth);
  return (
    <div class="chips stage-chips" role="group" aria-label="Layers of the field">
      {LAYERS.filter(([id]) => id !== "truth" || hasTruth).map(([id, name, color]) => (
        <button
          key={id}
          class="chip"
          aria-pressed={settings.layers[id]}
          title={HINTS[id]}
          onClick={() => set({ layers: { ...settings.layers, [id]: !settings.layers[id] } })}
        >
          {color ? <i class="dot" style={{ background: color }} /> : <PoseMark kind={id} />}
          {name}
        </button>
      ))}
    </div>
  );
}

export default { id: "field", title: "Field", area: "left", key: "1", Component: Field };
