// SPDX-License-Identifier: MIT
// The tiles of the wall at the instant of a flip.
import assert from "node:assert/strict";
import { test } from "node:test";

import { roomOf } from "../../../workbench/views/live/page/source/room.js";
import { Store } from "../../../workbench/views/live/page/source/store.js";

const encode = (value) => new TextEncoder().encode(JSON.stringify(value));

/// A robot at x 1 that flips its pose at 0.2 s, and compares the room at 0, 0.2 and 0.4 s.
function flippedAt({ room = [0, 0.2, 0.4] } = {}) {
  const store = new Store();
  for (let i = 0; i <= 6; ++i) {
    const time = i * 0.1;
    const isFlipped = time > 0.19;
    const world = { pose: { x: isFlipped ? -1 : 1, y: 0, rotation: isFlipped ? Math.PI : 0 }, robot: { head_yaw: 0.5 } };
    store.receive("/world", time * 1e6, encode(world));
    const isCompared = room.some((one) => Math.abs(one - time) < 1e-3);
    const evidence = time > 0.21 ? -2 : 2; // compared before the flip
    const inView = [{ tile: 0, believed: evidence > 0 ? 0.9 : 0.1, mirrored: evidence > 0 ? 0.1 : 0.9 }];
    const message = { rows: 1, columns: 1, sum: evidence, evidence: [evidence], in_view: inView, view: [] };
    if (isCompared) store.receive("/room", time * 1e6, encode(message));
    if (i !== 2) continue;
    const flip = { machine: "orientation", state: "correcting", command: "flip_pose", verdict: "granted", reason: "r" };
    store.receive("/events", time * 1e6, encode(flip));
  }
  return store;
}

const shownAt = (store, time) => {
  store.show(time + 1e-3);
  const { tiles, pose, flip, headYaw } = roomOf(store);
  assert.equal(headYaw, 0.5);
  const rounded = flip && Math.round(1e3 * flip) / 1e3;
  return { sum: tiles.sum, evidence: tiles.evidence, seen: tiles.inView.get(0), x: pose.x, flip: rounded };
};

test("before a flip the tiles are those of the robot", () => {
  const seen = { tile: 0, believed: 0.9, mirrored: 0.1 };
  assert.deepEqual(shownAt(flippedAt(), 0.1), { sum: 2, evidence: [2], seen, x: 1, flip: null });
});

test("at a flip, tiles and views have the names of after it, as the panel of the field", () => {
  const seen = { tile: 0, believed: 0.1, mirrored: 0.9 };
  for (const time of [0.2, 0.3])
    assert.deepEqual(shownAt(flippedAt(), time), { sum: -2, evidence: [-2], seen, x: -1, flip: 0.2 });
  const late = shownAt(flippedAt({ room: [0, 0.1, 0.4] }), 0.3);
  assert.deepEqual([late.sum, late.x, late.flip], [-2, -1, 0.2]);
  assert.deepEqual(shownAt(flippedAt(), 0.4), { sum: -2, evidence: [-2], seen, x: -1, flip: null });
});

test("without a comparison there are no tiles", () => {
  assert.equal(roomOf(flippedAt({ room: [] })), null);
});
