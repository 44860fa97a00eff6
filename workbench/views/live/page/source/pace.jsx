// SPDX-License-Identifier: MIT
// The pace of the run in the header: pause, single frames, speed.
import { canSetPace, run, setPace } from "./operator.js";
import { canControl, togglePlay } from "./replay.js";
import { useChanges } from "./ticker.js";

const SPEEDS = [0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10, 20];

/// A list of speeds. of: the run or the replay.
export function SpeedChoice({ of, speed, onChoose }) {
  const speeds = SPEEDS.includes(speed) ? SPEEDS : [...SPEEDS, speed].sort((a, b) => a - b);
  return (
    <select
      class="button"
      aria-label={`Speed of the ${of}`}
      title="Speed; 1× is real time"
      value={speed}
      onChange={(event) => onChoose(Number(event.currentTarget.value))}
    >
      {speeds.map((one) => (
        <option key={one} value={one}>
          {Number(one.toPrecision(3))}×
        </option>
      ))}
    </select>
  );
}

export function Pace() {
  useChanges(500);
  if (!canSetPace()) return null;
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
      <SpeedChoice of="run" speed={run.speed} onChoose={(factor) => setPace("speed", { factor })} />
    </div>
  );
}

/// The keys of the run.
export function togglePause() {
  if (canControl()) togglePlay();
  else if (canSetPace()) setPace(run.paused ? "resume" : "pause");
}
export function runOneFrame() {
  if (canSetPace()) setPace("frame");
}
