// SPDX-License-Identifier: MIT
// The pace of the run in the header: pause, single frames, speed.
import { canSetPace, run, setPace } from "./operator.js";
import { useChanges } from "./ticker.js";

const SPEEDS = [0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10, 20];

export function Pace() {
  useChanges(500);
  if (!canSetPace()) return null;
  const speeds = SPEEDS.includes(run.speed) ? SPEEDS : [...SPEEDS, run.speed].sort((a, b) => a - b);
  return (
    <div class="pace" role="group" aria-label="Pace of the run">
      <button
        class="button"
        aria-pressed={run.paused}
        title={`${run.paused ? "Resume" : "Pause"} the run (P)`}
        onClick={() => setPace(run.paused ? "resume" : "pause")}
      >
        {run.paused ? "Resume" : "Pause"}
        <span class="wide">&nbsp;run</span>
      </button>
      <button
        class="button"
        disabled={!run.paused}
        aria-label="One frame"
        title="Run one frame (.)"
        onClick={() => setPace("frame")}
      >
        +1
      </button>
      <select
        class="button"
        aria-label="Speed of the run"
        title="Speed; 1× is real time"
        value={run.speed}
        onChange={(event) => setPace("speed", { factor: Number(event.currentTarget.value) })}
      >
        {speeds.map((speed) => (
          <option key={speed} value={speed}>
            {speed}×
          </option>
        ))}
      </select>
    </div>
  );
}

/// The keys of the run.
export function togglePause() {
  if (canSetPace()) setPace(run.paused ? "resume" : "pause");
}
export function runOneFrame() {
  if (canSetPace()) setPace("frame");
}
