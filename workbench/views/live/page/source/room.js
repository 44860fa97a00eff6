// SPDX-License-Identifier: MIT
// The tiles of the wall at the shown instant. The robot compares them with the believed pose before it flips, and not
// in each frame. So after a flip the last tiles name the poses of before it, and are shown with the names of after it.
import { mirrored } from "./draw/field.js";
import { swapped, tilesOf } from "./draw/tiles.js";

const MAX_AGE = 60; // s
const TOLERANCE = 1e-6; // s

/// The granted flips from one time to another, both included.
function flipsOf(store, from, to) {
  return store.events.filter(
    ({ time, command, granted }) =>
      command === "flip_pose" && granted && time >= from - TOLERANCE && time <= to + TOLERANCE,
  );
}

/// The last message of /room, and the pose to which its view belongs: {tiles, pose, headYaw, time, flip}, or null.
/// flip: the time of a flip after the comparison, else null.
export function roomOf(store) {
  const found = store.read("/room", MAX_AGE);
  if (!found) return null;
  const frame = store.frames[store.indexAt(found.time)];
  const flips = flipsOf(store, found.time, store.shown().time);
  const tiles = tilesOf(found.value);
  const isSwapped = flips.length % 2 === 1;
  // The pose of a frame is that after its flip.
  const since = flips.filter(({ time }) => time > found.time + TOLERANCE).length;
  return {
    tiles: isSwapped ? swapped(tiles) : tiles,
    pose: frame?.pose && (since % 2 === 1 ? mirrored(frame.pose) : frame.pose),
    headYaw: frame?.headYaw ?? 0,
    time: found.time,
    flip: flips.at(-1)?.time ?? null,
  };
}
