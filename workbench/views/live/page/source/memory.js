// SPDX-License-Identifier: MIT
// Keeps the received frames within a budget: first thins the images, then drops them, then the same for the other large
// messages, and at last drops the oldest frames.

export const IMAGE_TOPICS = ["/camera/upper/image", "/camera/lower/image"];
const IMAGES = [...IMAGE_TOPICS, "/camera/upper/annotations", "/camera/lower/annotations"];
const DETAILS = ["/percepts", "/belief/particles", "/room", "/costs", "/conditions"];
const WALL = ["/wall"]; // not sent while its colors stay the same

/// What to thin, in this order: topics, and the smallest time in s between two of their messages.
const STEPS = [
  [IMAGES, 0.1],
  [IMAGES, 0.2],
  [IMAGES, 0.5],
  [DETAILS, 0.2],
  [IMAGES, 1],
  [IMAGES, 2],
  [DETAILS, 1],
  [WALL, 5],
  [IMAGES, Infinity],
  [DETAILS, Infinity],
  [WALL, Infinity],
];
const RECENT = 10; // s that stay complete as long as possible
const ENOUGH = 0.9; // fraction of the budget at which thinning ends

/// Bytes of a part: its data, and roughly what the browser needs for each array.
export function sizeOf(part) {
  return (part.bytes?.byteLength ?? part.byteLength ?? 0) + 200;
}

function thin(frames, topics, spacing, until) {
  let freed = 0;
  let last = -Infinity;
  for (const frame of frames) {
    if (frame.time >= until) break;
    const present = topics.filter((topic) => topic in frame.parts);
    if (!present.length) continue;
    // Tolerates the rounding of times. An infinite spacing drops every message.
    if (spacing !== Infinity && frame.time - last >= spacing - 0.002) {
      last = frame.time;
      continue;
    }
    for (const topic of present) {
      freed += sizeOf(frame.parts[topic]);
      delete frame.parts[topic];
    }
    frame.thinned = true;
  }
  return freed;
}

/// Thins `frames`, which are in the order of their times and need `size` bytes, until they fit. Returns the new size
/// and the number of oldest frames to drop.
export function fit(frames, size, budget) {
  if (size <= budget || !frames.length) return { size, drop: 0 };
  const goal = ENOUGH * budget;
  const newest = frames[frames.length - 1].time;
  for (const [topics, spacing] of STEPS) {
    size -= thin(frames, topics, spacing, newest - RECENT);
    if (size <= goal) return { size, drop: 0 };
  }
  let drop = 0;
  while (size > goal && drop < frames.length - 1) {
    for (const part of Object.values(frames[drop].parts)) size -= sizeOf(part);
    size -= FRAME_SIZE;
    ++drop;
  }
  return { size, drop };
}

/// Roughly what a frame needs besides its parts: numbers, objects.
export const FRAME_SIZE = 400;
