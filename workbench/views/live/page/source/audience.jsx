// SPDX-License-Identifier: MIT
// The view for an audience: the field with the wall around it, and one sentence about what the robot thinks. Large and
// read-only.
import { ConnectionState, Thought } from "./app.jsx";
import { Canvas } from "./draw/canvas.jsx";
import { palette } from "./draw/palette.js";
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

function Legend() {
  useChanges(1000);
  const entries = [
    ["where the robot thinks it is, and tiles of the wall that fit", palette.belief],
    ["the mirrored place, and tiles that fit it (striped)", palette.opposite],
  ];
  if (store.shown()?.truth) entries.push(["where it really is", palette.truth]);
  entries.push(["which part of the wall it recognizes", palette.view]);
  return (
    <p class="legend">
      {entries.map(([name, color]) => (
        <span key={name}>
          <i class="dot" style={{ background: color }} />
          {name}
        </span>
      ))}
    </p>
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
