// SPDX-License-Identifier: MIT
// The controls of a replay: play, pause and speed in the header, and a bar over the whole recording in the timeline.
import { useState } from "preact/hooks";

import { fixed } from "./format.js";
import { SpeedChoice } from "./pace.jsx";
import { canControl, isPlaying, isStored, recorded, replay, seek, setReplaySpeed, togglePlay } from "./replay.js";
import { store } from "./robot.js";
import { useChanges } from "./ticker.js";

const STEP = 1 / 30; // s

export function ReplayPace() {
  useChanges(200);
  if (!canControl()) return null;
  const isRunning = store.isLive && isPlaying();
  const what = isRunning ? "Pause" : store.isLive ? "Play" : "Play from here";
  return (
    <div class="pace" role="group" aria-label="Pace of the replay">
      <button class="button" aria-pressed={!isRunning} title={`${what} (P)`} onClick={togglePlay}>
        {what}
      </button>
      <SpeedChoice of="replay" speed={replay.speed} onChoose={setReplaySpeed} />
    </div>
  );
}

/// A slider over the time of the recording. Within the received frames it shows an instant; elsewhere it seeks.
export function RecordingBar() {
  useChanges(100);
  const [moving, setMoving] = useState(null); // s, while the user moves the slider
  const range = recorded();
  if (!range || !canControl()) return null;
  const [begin, end] = range;
  const time = moving ?? store.shown()?.time ?? begin;
  const move = (event) => {
    const target = Number(event.currentTarget.value);
    setMoving(target);
    if (isStored(target)) store.show(target);
  };
  const finish = (event) => {
    const target = Number(event.currentTarget.value);
    if (!isStored(target)) seek(target);
    setMoving(null);
  };
  return (
    <label class="row tight recording">
      <span>Recording</span>
      <input
        type="range"
        class="grow"
        min={begin}
        max={end}
        step={STEP}
        value={time}
        aria-label="Time of the recording"
        onInput={move}
        onChange={finish}
      />
      <span class="value">
        {fixed(time, 2)} of {fixed(end, 2)} s
      </span>
    </label>
  );
}
