// SPDX-License-Identifier: MIT
// The plots of the timeline: evidence and confidences. All tracks of the timeline share the gutter on the left.
import uPlot from "uplot";

import { LINEAR, endOf, markText, marksOf, ticksOf } from "./evidence_scale.js";
import { themeColor } from "./palette.js";

export const GUTTER = 104; // pixels
export const RIGHT = 10;
const MOST_POINTS = 1500;
const GAP = 1; // s without a frame, over which no line is drawn
const FONT = "11px system-ui, sans-serif";
const APART = 13; // pixels between two labels of the evidence
const TITLE_LINE = 13; // pixels

/// A title in the gutter, as those of the other tracks. `lines`: its texts.
function drawTitle(plot, lines) {
  const { ctx: context, bbox: box } = plot;
  context.save();
  context.font = `${11 * devicePixelRatio}px system-ui, sans-serif`;
  context.fillStyle = themeColor("soft");
  context.textAlign = "left";
  context.textBaseline = "middle";
  lines.forEach((line, i) => {
    const offset = TITLE_LINE * (i - 0.5 * (lines.length - 1));
    context.fillText(line, 8 * devicePixelRatio, box.top + box.height / 2 + offset * devicePixelRatio);
  });
  context.restore();
}

function common(width, height, range, marks, format, title) {
  return {
    width,
    height,
    padding: [6, RIGHT, 6, 0],
    cursor: { show: false },
    legend: { show: false },
    axes: [
      { show: false },
      {
        size: GUTTER,
        font: FONT,
        stroke: themeColor("soft"),
        grid: { stroke: themeColor("rule"), width: 1 },
        ticks: { show: false },
        splits: marks,
        values: (plot, splits) => splits.map(format),
        space: 10,
      },
    ],
    scales: { x: { time: false, range } },
    hooks: { draw: [(plot) => drawTitle(plot, title.split("\n"))] },
  };
}

function drawLimits(plot, limit) {
  if (!limit) return;
  const { ctx: context, bbox: box } = plot;
  context.save();
  context.setLineDash([5, 4]);
  context.lineWidth = devicePixelRatio;
  for (const [value, color] of [
    [limit.unconfirmed, "mirrored"],
    [-limit.unconfirmed, "belief"],
  ]) {
    const y = plot.valToPos(value, "y", true);
    context.strokeStyle = themeColor(color);
    context.beginPath();
    context.moveTo(box.left, y);
    context.lineTo(box.left + box.width, y);
    context.stroke();
  }
  context.restore();
}

/// Short lines beside the labels.
function drawTicks(plot) {
  const { ctx: context, bbox: box } = plot;
  const long = 3 * devicePixelRatio;
  context.save();
  context.fillStyle = themeColor("gray");
  for (const tick of ticksOf(plot.scales.y.max, box.height / devicePixelRatio)) {
    const y = Math.round(plot.valToPos(tick, "y", true));
    context.fillRect(box.left - long, y, long, devicePixelRatio);
  }
  context.restore();
}

/// `range()`: [from, to] of the time axis. `limits()`: thresholds of the evidence, or null.
export function evidencePlot(element, width, height, range, limits) {
  const splits = (plot, axis, low, high) => marksOf(high, plot.bbox.height / devicePixelRatio, APART);
  const options = common(width, height, range, splits, markText, "evidence\n(log scale)");
  options.axes[1].filter = (plot, marks) => marks; // all: by default uPlot leaves out those that are no power of 10
  options.scales.y = {
    distr: 4,
    asinh: LINEAR,
    range: (plot, low, high) => [-endOf(low, high), endOf(low, high)],
  };
  options.series = [
    {},
    { fill: themeColor("red-soft"), stroke: "transparent", points: { show: false } },
    { fill: themeColor("blue-soft"), stroke: "transparent", points: { show: false } },
    { stroke: themeColor("evidence"), width: 1.5, points: { show: false } },
  ];
  for (const series of options.series.slice(1, 3)) series.fillTo = 0;
  options.hooks.draw.push(drawTicks, (plot) => drawLimits(plot, limits()));
  return new uPlot(options, [[], [], [], []], element);
}

export function confidencePlot(element, width, height, range) {
  const options = common(width, height, range, () => (height < 50 ? [0, 1] : [0, 0.5, 1]), String, "confidence");
  options.scales.y = { range: [-0.04, 1.04] };
  options.series = [
    {},
    { stroke: themeColor("mirrored"), width: 1.75, points: { show: false } },
    { stroke: themeColor("belief"), width: 1.75, points: { show: false } },
  ];
  return new uPlot(options, [[], [], []], element);
}

/// Indices of frames between two: all of them, or for each of many equal parts those with the least and the most
/// evidence, so that a short peak is visible in a long time. Parts begin at multiples of their length since the start,
/// so that the same frames are chosen while the view moves.
function chosenFrames(store, first, last) {
  const part = 2 * Math.ceil((last - first) / MOST_POINTS);
  const begin = part > 2 ? first - ((first + store.droppedFrames) % part) : first;
  const chosen = [];
  for (let i = Math.max(0, begin); i <= last; i += part > 2 ? part : 1) {
    let [least, most] = [i, i];
    for (let j = i; part > 2 && j < Math.min(i + part, last + 1); ++j) {
      if (store.frames[j].evidence < store.frames[least].evidence) least = j;
      if (store.frames[j].evidence > store.frames[most].evidence) most = j;
    }
    chosen.push(Math.min(least, most));
    if (least !== most) chosen.push(Math.max(least, most));
  }
  return chosen;
}

/// The columns of the plots between two times: {evidence, confidence}.
export function columnsOf(store, from, to) {
  const first = Math.max(0, store.indexAt(from));
  const last = Math.min(store.frames.length - 1, store.indexAt(to) + 1);
  const [time, above, under, evidence, current, opposite] = [[], [], [], [], [], []];
  for (const i of chosenFrames(store, first, last)) {
    const frame = store.frames[i];
    if (!frame?.pose) continue;
    if (frame.time - time.at(-1) > GAP && frame.time - store.frames[i - 1].time > GAP) {
      time.push(frame.time - 1e-3);
      for (const column of [above, under, evidence, current, opposite]) column.push(null);
    }
    const value = frame.evidence ?? null;
    time.push(frame.time);
    evidence.push(value);
    above.push(value === null ? null : Math.max(0, value));
    under.push(value === null ? null : Math.min(0, value));
    current.push(frame.current ?? null);
    opposite.push(frame.opposite ?? null);
  }
  return { evidence: [time, above, under, evidence], confidence: [time, opposite, current] };
}
