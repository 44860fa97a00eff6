// SPDX-License-Identifier: MIT
// The scale of the evidence in all drawings: a symmetric logarithm, so that 0.5 and 100 are both readable.

export const LINEAR = 1; // log-odds up to which the scale is roughly linear
const LEAST = 12; // log-odds that each axis contains, so that the thresholds of a decision are on it
const ROOM = 1.1; // of the end of an axis to its largest value
const DECADES = [1000, 100, 10, 1];
const BETWEEN = [300, 30, 3];
const STEPS = [[1, 2, 3, 4, 5, 6, 7, 8, 9], [1, 2, 5], [1]];
const TICKS_APART = 3; // pixels

/// The end of an axis, in log-odds, that contains values from `low` to `high`; null: unknown.
export const endOf = (low, high) => ROOM * Math.max(LEAST, Math.abs(low ?? 0), Math.abs(high ?? 0));

/// The position of a value on an axis from −end to end, from −1 to 1. Values outside are at the ends.
export const positionOf = (value, end) =>
  Math.max(-1, Math.min(1, Math.asinh(value / LINEAR) / Math.asinh(end / LINEAR)));

/// The values to label on an axis of `length` pixels, at least `apart` pixels from each other: 0, powers of 10, and
/// between these three times a power of 10.
export function marksOf(end, length, apart) {
  const at = (value) => 0.5 * length * positionOf(value, end);
  const marks = [];
  for (const mark of [...DECADES, ...BETWEEN])
    if (mark < end && [0, ...marks].every((other) => Math.abs(at(mark) - at(other)) >= apart)) marks.push(mark);
  marks.sort((some, other) => some - other);
  return [...marks.map((mark) => -mark).reverse(), 0, ...marks];
}

/// The values of the short lines between the labels, which show that the axis is logarithmic: as many of each power of
/// 10 as an axis of `length` pixels can show.
export function ticksOf(end, length) {
  const isApart = (some, other) => 0.5 * length * (positionOf(other, end) - positionOf(some, end)) >= TICKS_APART;
  const steps = STEPS.find((them) => them.every((step, i) => isApart(end * 0.1 * step, end * 0.1 * (them[i + 1] ?? 10))));
  const ticks = [];
  for (let decade = LINEAR; steps && decade < end; decade *= 10)
    for (const step of steps) if (step * decade < end) ticks.push(-step * decade, step * decade);
  return ticks;
}

/// A value of the scale as text.
export const markText = (value) => String(value).replace("-", "−");
