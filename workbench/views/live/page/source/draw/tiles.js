// SPDX-License-Identifier: MIT
// The evidence of the tiles of the wall: which tiles match the believed pose, and which the mirrored pose.
import { wrapped } from "../format.js";
import { palette } from "./palette.js";

export const FULL_EVIDENCE = 1; // log-odds of a tile at which its color is full, as in scene/color.h
const LEAST = 0.02; // log-odds below which a tile supports neither pose
const SMALL = 10; // pixels, below which a tile is filled, because a frame would hide it
const NEAR = 0.03; // rad, less than a cell of a grid and more than the distance of particles
const FULL = 0.3; // fraction of the belief at which a bar is highest
const STRIPES = 7; // pixels between two stripes
const cache = new WeakMap();
const swaps = new WeakMap(); // tiles: the swapped ones

/// {rows, columns, sum, evidence: [log-odds], inView: Map of tile to {believed, mirrored}, belief: bars} of a message of
/// /room.
export function tilesOf(message) {
  let tiles = cache.get(message);
  if (!tiles) {
    const { rows, columns, sum, evidence, in_view: inView, view } = message;
    const belief = barsOf(view.map(({ azimuth, share }) => ({ azimuth, height: share })));
    tiles = { rows, columns, sum, evidence, inView: new Map(inView.map((seen) => [seen.tile, seen])), belief };
    cache.set(message, tiles);
  }
  return tiles;
}

/// The same tiles, compared with the poses after a flip: what was the mirrored pose is the believed one.
export function swapped(tiles) {
  let other = swaps.get(tiles);
  if (!other) {
    const inView = [...tiles.inView].map(([tile, { believed, mirrored }]) => [
      tile,
      { tile, believed: mirrored, mirrored: believed },
    ]);
    other = { ...tiles, sum: -tiles.sum, evidence: tiles.evidence.map((it) => -it), inView: new Map(inView) };
    swaps.set(tiles, other);
  }
  return other;
}

/// The parts of the belief of the view, [{azimuth, height}], as bars over the azimuth: [{azimuth, bar}]. The height of a
/// bar, from 0 to 1, is the root of the fraction of the belief around its azimuth, so that a uniform belief has low bars.
export function barsOf(all) {
  const sum = all.reduce((total, { height }) => total + height, 0);
  return all.map(({ azimuth }) => {
    let around = 0;
    for (const other of all) if (Math.abs(wrapped(other.azimuth - azimuth)) < NEAR) around += other.height;
    return { azimuth, bar: Math.min(1, Math.sqrt(around / sum / FULL)) };
  });
}

const parts = (color) => [1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16));

/// From blue for the believed pose through gray to red for the mirrored pose.
export function evidenceColor(logOdds) {
  const full = parts(logOdds > 0 ? palette.opposite : palette.belief);
  const share = Math.sqrt(Math.min(1, Math.abs(logOdds) / FULL_EVIDENCE));
  const mixed = parts(palette.noEvidence).map((from, i) => Math.round((1 - share) * from + share * full[i]));
  return `rgb(${mixed.join(", ")})`;
}

/// Diagonal stripes: the sign of a tile that matches the mirrored pose, also for people who cannot see its color.
function drawStripes(context, color, size, [left, top, right, bottom]) {
  const tall = bottom - top;
  const step = size < SMALL ? STRIPES / 2 : STRIPES;
  context.beginPath();
  for (let u = left - tall + step / 2; u < right; u += step) {
    context.moveTo(u, bottom);
    context.lineTo(u + tall, top);
  }
  context.lineWidth = size < SMALL ? 1 : 2;
  context.strokeStyle = color;
  context.stroke();
}

/// Draws the evidence of a tile inside of its outline: a frame, thick for a tile in view, with stripes for the mirrored
/// pose. A small tile is filled. `trace()` makes the path of the outline; `size`: the smaller side; `box`: [left, top,
/// right, bottom] around it; all in pixels.
export function drawEvidence(context, tiles, tile, trace, size, box) {
  const evidence = tiles.evidence[tile];
  const inView = tiles.inView.has(tile);
  const isSmall = size < SMALL;
  if (evidence === undefined || (!inView && (isSmall || Math.abs(evidence) < LEAST))) return;
  const color = evidenceColor(evidence);
  context.save();
  context.beginPath();
  trace();
  context.clip();
  if (isSmall) {
    context.fillStyle = color;
    context.fill();
  } else {
    const thick = Math.min(4, 0.18 * size);
    // The outer half of a stroke is clipped.
    const strokes = inView ? [["#fff", 2 * thick + 2.5], [color, 2 * thick]] : [[color, Math.min(3, thick)]];
    for (const [style, width] of strokes) {
      context.lineWidth = width;
      context.strokeStyle = style;
      context.stroke();
    }
  }
  if (inView && evidence >= LEAST) drawStripes(context, isSmall ? "#fff" : color, size, box);
  context.restore();
}

/// The number of the tile at an azimuth (rad) and in a row, or null.
export function tileAt(tiles, azimuth, row) {
  if (!(row >= 0 && row < tiles.rows)) return null;
  const turn = (wrapped(azimuth) + 2 * Math.PI) % (2 * Math.PI);
  return row * tiles.columns + Math.min(tiles.columns - 1, Math.floor((turn / (2 * Math.PI)) * tiles.columns));
}

const signed = (value, digits) => `${value > 0 ? "+" : value < 0 ? "−" : ""}${Math.abs(value).toFixed(digits)}`;

/// What is known about a tile, as short texts.
export function factsOf(tiles, tile) {
  const [row, column] = [Math.floor(tile / tiles.columns), tile % tiles.columns];
  const evidence = tiles.evidence[tile] ?? 0;
  const seen = tiles.inView.get(tile);
  const side = Math.abs(evidence) < LEAST ? "neither" : evidence > 0 ? "mirrored" : "believed";
  const facts = [
    `Column ${column}, row ${row}${seen ? ", in view" : ""}`,
    `evidence ${signed(evidence, 2)} of ${signed(tiles.sum, 1)} (${side})`,
  ];
  if (!seen) return facts;
  const { believed, mirrored } = seen;
  const known = (value) => (value === undefined ? "not learned" : value.toFixed(2));
  facts.push(`distance to the model ${known(believed)} if believed, ${known(mirrored)} if mirrored`);
  return facts;
}
