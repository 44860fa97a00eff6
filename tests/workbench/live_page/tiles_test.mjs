// SPDX-License-Identifier: MIT
// The evidence of tiles: colors, the tile at a position, texts; and detections that are drawn hollow.
import assert from "node:assert/strict";
import { test } from "node:test";

import { drawHollow, isHollow, outlineOf } from "../../../workbench/views/live/page/source/draw/fits.js";
import { evidenceColor, factsOf, tileAt, tilesOf } from "../../../workbench/views/live/page/source/draw/tiles.js";

const message = {
  rows: 2,
  columns: 8,
  sum: -3.25,
  evidence: Array.from({ length: 16 }, (_, i) => (i === 9 ? 0.5 : i === 2 ? -1.5 : 0)),
  in_view: [{ tile: 9, believed: 0.4, mirrored: 0.3 }, { tile: 2, mirrored: 0.125 }],
  view: [{ azimuth: 0.5, share: 1 }, { azimuth: 0.51, share: 1 }, { azimuth: -3.1, share: 0.5 }],
};

test("the color of a tile goes from blue for the believed pose through gray to red", () => {
  assert.equal(evidenceColor(-5), "rgb(21, 88, 214)");
  assert.equal(evidenceColor(0), "rgb(190, 195, 201)");
  assert.equal(evidenceColor(1), "rgb(212, 48, 52)");
  assert.equal(evidenceColor(2), evidenceColor(1));
  assert.notEqual(evidenceColor(0.1), evidenceColor(0));
});

test("the tile at an azimuth is counted to the left from the direction of the opponents' goal", () => {
  const tiles = tilesOf(message);
  assert.equal(tileAt(tiles, 0.01, 0), 0);
  assert.equal(tileAt(tiles, -0.01, 0), 7);
  assert.equal(tileAt(tiles, Math.PI, 1), 12);
  assert.equal(tileAt(tiles, -Math.PI, 1), 12);
  assert.equal(tileAt(tiles, 0, 2), null);
  assert.equal(tileAt(tiles, 0, -1), null);
});

test("a bar of the view is the root of the belief around it", () => {
  const [first, second, apart] = tilesOf(message).belief;
  assert.equal(first.bar, 1);
  assert.equal(second.azimuth, 0.51);
  assert.ok(Math.abs(apart.bar - Math.sqrt(0.2 / 0.3)) < 1e-9);
});

test("the numbers of a tile name the pose that it matches", () => {
  const tiles = tilesOf(message);
  assert.deepEqual(factsOf(tiles, 9), [
    "Column 1, row 1, in view",
    "evidence +0.50 of −3.3 (mirrored)",
    "distance to the model 0.40 if believed, 0.30 if mirrored",
  ]);
  assert.match(factsOf(tiles, 2)[1], /−1.50 .* \(believed\)/);
  assert.match(factsOf(tiles, 2)[2], /not learned if believed, 0.13 if mirrored/);
  assert.deepEqual(factsOf(tiles, 3).length, 2);
  assert.match(factsOf(tiles, 3)[1], /\(neither\)/);
});

test("a translucent detection is drawn hollow, and one that is not used is pale", () => {
  assert.equal(isHollow("rgba(0, 214, 255, 1)"), false);
  assert.equal(isHollow("rgba(0, 214, 255, 0.4)"), true);
  assert.equal(outlineOf("rgba(0, 214, 255, 0.4)"), "rgba(0, 214, 255, 1)");
  assert.equal(outlineOf("rgba(0, 214, 255, 0.2)"), "rgba(0, 214, 255, 0.45)");
});

test("hollow marks do not overlap, because they would look like a solid line", () => {
  const drawn = [];
  const context = { beginPath() {}, stroke() {}, arc: (u) => drawn.push(u) };
  drawHollow(context, [0, 2, 4, 9, 11, 30].map((u) => ({ u, v: 5, color: "rgba(0, 214, 255, 0.4)" })));
  assert.deepEqual(drawn, [0, 9, 30]);
});
