// SPDX-License-Identifier: MIT
// The labels of the poses on the field: together where poses coincide, and within the drawing.
import assert from "node:assert/strict";
import { test } from "node:test";

import { labelsOf } from "../../../workbench/views/live/page/source/draw/pose_labels.js";

const [WIDTH, HEIGHT, FONT] = [400, 300, 10];
const measure = (text) => 6 * text.length;
const mark = (text, u, v, reach = 20) => ({ text, u, v, reach, ink: text });
const labels = (...marks) => labelsOf(marks, measure, FONT, WIDTH, HEIGHT);
const textOf = ({ parts }) => parts.map(({ text }) => text).join("");

test("each pose has its own label, below its mark", () => {
  const all = labels(mark("believed", 100, 100), mark("mirrored", 300, 200));
  assert.deepEqual(all.map(textOf), ["believed", "mirrored"]);
  for (const [i, [u, v]] of [[100, 100], [300, 200]].entries()) {
    assert.ok(all[i].left < u && u < all[i].left + all[i].wide);
    assert.ok(all[i].top > v);
  }
});

test("poses that coincide share a label, with the color of each", () => {
  const [label, ...others] = labels(mark("believed", 100, 100), mark("true", 104, 98, 30));
  assert.equal(textOf(label), "believed + true");
  assert.equal(others.length, 0);
  assert.deepEqual(label.parts.map(({ ink }) => ink).filter((ink) => !ink.startsWith("#")), ["believed", "true"]);
});

test("no label leaves the drawing", () => {
  for (const [u, v] of [[0, 0], [WIDTH, 0], [0, HEIGHT], [WIDTH, HEIGHT], [WIDTH / 2, HEIGHT - 5]]) {
    const [{ left, top, wide, tall }] = labels(mark("believed", u, v));
    assert.ok(left >= 0 && top >= 0 && left + wide <= WIDTH && top + tall <= HEIGHT, `${u}, ${v}: ${left}, ${top}`);
  }
});

test("a label does not cover another mark or label if there is room", () => {
  const marks = [mark("believed", 100, 100), mark("mirrored", 100, 130)];
  const all = labels(...marks);
  assert.equal(all.length, 2);
  const [first, second] = all;
  const apart = first.top + first.tall <= second.top || second.top + second.tall <= first.top ||
    first.left + first.wide <= second.left || second.left + second.wide <= first.left;
  assert.ok(apart);
  assert.ok(first.top + first.tall <= 110 || first.left >= 120 || first.left + first.wide <= 80, "beside the other mark");
});
