// SPDX-License-Identifier: MIT
// A replay of a recording: where it is, and the requests of this page to play, pause, seek and set the speed.
import { dataRange, isReplay, link, onPlayback, sendPlayback, store } from "./robot.js";

const STATUS = ["playing", "paused", "buffering", "ended"];

const GAP = 0.5; // s without a frame

/// status: of STATUS, or an empty text before the robot has sent it; time: s; speed: times real time.
export const replay = { status: "", time: 0, speed: 1 };

onPlayback((state) => {
  replay.status = STATUS[state.status] ?? "";
  replay.time = state.time;
  replay.speed = state.speed;
  store.isStill = !isPlaying(); // the newest frame is complete
});

export const isPlaying = () => replay.status === "playing" || replay.status === "buffering";
/// Whether this page may control the replay, and knows its state: before that, a key to pause would play.
export const canControl = () => link.state === "open" && isReplay() && !link.refusal && replay.status !== "";

const request = (values) => sendPlayback({ pauses: !isPlaying(), speed: replay.speed, ...values });
export const setReplaySpeed = (speed) => request({ speed });

/// Continues at `time` (s), playing or paused as before.
export function seek(time, values = {}) {
  request({ seek: time, ...values });
  store.rewind(time); // so that no later frame is shown until the robot sends that one
  store.show(null);
}

/// Plays from the shown instant, or pauses.
export function togglePlay() {
  if (!store.isLive) seek(store.instant, { pauses: false });
  else request({ pauses: isPlaying() });
}

/// Whether the page has the frame of a time, so that it can show it without the robot.
export function isStored(time) {
  const frame = store.frames[store.indexAt(time)];
  return frame !== undefined && time <= store.newest && time - frame.time < GAP;
}

/// The first and the last time of the recording: [s, s], or null.
export const recorded = () => (isReplay() ? dataRange() : null);
