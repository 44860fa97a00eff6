// SPDX-License-Identifier: MIT
// The scale of the evidence: positions, labels and ticks of its axes.
import assert from "node:assert/strict";
import { test } from "node:test";

import {
  endOf,
  markText,
  marksOf,
  positionOf,
  ticksOf,
} from "../../../workbench/views/live/page/source/draw/evidence_scale.js";

test("the scale of the evidence is symmetric, and small values are visible", () => {
  assert.equal(positionOf(0, 100), 0);
  assert.equal(positionOf(100, 100), 1);
  assert.equal(positionOf(1e9, 100), 1);
  assert.equal(positionOf(-5, 100), -positionOf(5, 100));
  assert.ok(positionOf(1, 150) > 0.15);
});

test("an axis contains the thresholds, and all of its values", () => {
  assert.ok(endOf(null, null) > 12);
  assert.ok(endOf(-200, 3) > 200);
  assert.ok(endOf(-1, 300) > 300);
});

test("labels are as far apart as the axis allows, on a low axis, too", () => {
  assert.deepEqual(marksOf(127, 74, 15), [-100, -10, 0, 10, 100]);
  assert.deepEqual(marksOf(13.2, 74, 13), [-10, -3, 0, 3, 10]);
  assert.deepEqual(marksOf(13.2, 200, 15), [-10, -3, -1, 0, 1, 3, 10]);
  assert.deepEqual(marksOf(13.2, 20, 15), [0]);
  for (const length of [40, 90, 170, 400])
    for (const end of [13, 50, 300, 5000]) {
      const at = marksOf(end, length, 15).map((mark) => 0.5 * length * positionOf(mark, end));
      assert.ok(at.every((position, i) => i === 0 || position - at[i - 1] >= 15 - 1e-9), `${end} ${length}`);
    }
  assert.equal(markText(-10), "−10");
});

test("ticks are nine in each power of 10, or fewer on a short axis, on both sides", () => {
  const ticks = (end, length) => ticksOf(end, length).filter((tick) => tick > 0);
  assert.deepEqual(ticks(13.2, 300), [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
  assert.equal(ticksOf(13.2, 300).length, 20);
  assert.deepEqual(ticks(130, 100), [1, 2, 5, 10, 20, 50, 100]);
  assert.deepEqual(ticks(130, 40), [1, 10, 100]);
  assert.deepEqual(ticks(130, 0), []);
});
