// SPDX-License-Identifier: MIT
// The view for an audience: the field with the wall around it, and one sentence about what the robot thinks. Large and
// read-only.
import { ConnectionState, Thought } from "./app.jsx";
import { Canvas } from "./draw/canvas.jsx";
import { palette } from "./draw/palette.js";
import { POSE_MARKS, PoseMark } from "./draw/pose_marks.jsx";
import { drawField } from "./panels/field.jsx";
import { EvidenceBar } from "./panels/wall.jsx";
import { store } from "./robot.js";
import { useChanges } from "./ticker.js";

const LAYERS = {
  belief: true,
  cone: true,
  mirrored: true,
  truth: true,
  particles: false,
  percepts: false,
  path: true,
  ring: true,
};

export const isAudience = () => location.hash === "#audience" || location.pathname.endsWith("/audience");

/// The address of the page; null: /audience was opened without the token of the run, as for a public screen.
function pageAddress() {
  const { pathname, search } = location;
  if (!pathname.endsWith("/audience")) return "#";
  return search.includes("token=") ? pathname.replace(/audience$/, "") + search : null;
}

const POSES = [
  ["belief", "where the robot thinks it is"],
  ["mirrored", "the same place at the other side"],
  ["truth", "where it really is"],
];

function Legend() {
  useChanges(1000);
  const hasTruth = store.shown()?.truth;
  return (
    <div class="legend">
      {POSES.filter(([kind]) => kind !== "truth" || hasTruth).map(([kind, text]) => (
        <span key={kind}>
          <PoseMark kind={kind} />
          <span>
            <b>{POSE_MARKS[kind].label}</b>: {text}
          </span>
        </span>
      ))}
      <span>
        <i class="tile" style={{ color: palette.belief }} />
        <i class="tile striped" style={{ color: palette.opposite }} />
        tiles of the wall that fit these poses
      </span>
      <span>
        <i class="bars" style={{ color: palette.view }} />
        the part of the wall that it recognizes
      </span>
    </div>
  );
}

export function Audience() {
  const page = pageAddress();
  return (
    <div class="audience">
      <div class="stage">
        <Canvas
          draw={(context, width, height) => drawField(context, width, height, LAYERS)}
          label="The field from above, and the wall of the room around it"
        />
      </div>
      <aside>
        <Thought />
        <div>
          <h2>The colors of the room support</h2>
          <EvidenceBar />
        </div>
        <Legend />
        <p class="foot">
          <ConnectionState />
          {page !== null && (
            <a class="soft" href={page} title="Back to the page (A)">
              Back to the page
            </a>
          )}
        </p>
      </aside>
    </div>
  );
}
