// SPDX-License-Identifier: MIT
// The lower tracks of the timeline: states as bands with their names, marks of commands, edits and notes, and the time
// axis.
import { GUTTER, RIGHT } from "./plots.js";
import { statusBands, themeColor } from "./palette.js";

export const ROW = 17; // pixels
export const AXIS = 19;
export const FONT = "11px system-ui, sans-serif";
const HUES = [212, 160, 32, 276, 338, 96, 190, 250, 12, 60];
const TICKS = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300];
const REORIENTATIONS = ["flip_pose", "purge_reflection", "reset_orientation"];

const hues = new Map(); // name of a state: index of its hue

/// An index of HUES that no other state has, as long as there is one.
function hueOf(value) {
  if (hues.has(value)) return hues.get(value);
  let hash = 0;
  for (const letter of value) hash = (hash * 31 + letter.charCodeAt(0)) >>> 0;
  const used = new Set(hues.values());
  let index = hash % HUES.length;
  for (let i = 0; i < HUES.length && used.has(index); ++i) index = (index + 3) % HUES.length;
  hues.set(value, index);
  return index;
}

/// The color of a state: the same name has the same color in every band.
function colorOf(value, isDark) {
  const hue = HUES[hueOf(value)];
  return isDark ? `hsl(${hue} 32% 34%)` : `hsl(${hue} 48% 82%)`;
}

function clipped(context, text, width) {
  if (context.measureText(text).width <= width) return text;
  let length = text.length;
  while (length > 1 && context.measureText(`${text.slice(0, length)}…`).width > width) --length;
  return length > 1 ? `${text.slice(0, length)}…` : "";
}

export function drawLabel(context, text, middle) {
  context.fillStyle = themeColor("soft");
  context.textAlign = "left";
  context.fillText(clipped(context, text, GUTTER - 12), 8, middle);
}

/// `x(time)`: pixels. Entries of a band: {time, value}. The last one lasts until `newest`.
export function drawBand(context, band, row, range, x, isDark, isStatus, newest = Infinity) {
  const [from, to] = range;
  const top = row * ROW + 1;
  const middle = top + (ROW - 2) / 2;
  for (let i = band.length - 1; i >= 0; --i) {
    const begin = band[i].time;
    const end = band[i + 1]?.time ?? newest;
    if (begin >= to) continue;
    if (end <= from) break;
    const [left, right] = [x(Math.max(from, begin)), x(Math.min(to, end))];
    const { value } = band[i];
    if (!value) continue; // not known
    context.fillStyle = isStatus ? themeColor(statusBands[value] ?? "gray-band") : colorOf(value, isDark);
    context.fillRect(left, top, Math.max(1, right - left - 0.5), ROW - 2);
    if (right - left < 18) continue;
    context.fillStyle = themeColor("ink");
    context.textAlign = "left";
    context.fillText(clipped(context, value, right - left - 8), left + 4, middle);
  }
}

/// Whether a command changes the pose.
export const isReorientation = ({ command }) => REORIENTATIONS.includes(command);

/// The marks of the timeline: {time, row, kind, text}.
export function marksOf(store) {
  const marks = [];
  for (const event of store.events) {
    if (event.kind === "command") {
      const text = `${event.command} ${event.verdict} (${event.machine}: ${event.reason})`;
      const other = event.command.startsWith("action ") ? "action" : "pause";
      const granted = isReorientation(event) ? "granted" : other;
      marks.push({ time: event.time, row: 0, kind: event.granted ? granted : "refused", text });
    } else if (event.kind === "note") {
      marks.push({ time: event.time, row: 1, kind: "note", text: `note: ${event.text}` });
    } else if (event.kind === "game") {
      marks.push({ time: event.time, row: 1, kind: "note", text: `${event.machine}: ${event.text}` });
    }
  }
  for (const line of store.log) {
    const isEdit = line.name === "parameters" || line.message === "the edit is running";
    const isFault = line.level >= 4;
    if (isEdit || isFault)
      marks.push({ time: line.time, row: 1, kind: isFault ? "fault" : "edit", text: `${line.name}: ${line.message}` });
  }
  return marks;
}

const COLORS = { granted: "good", action: "good", pause: "gray", refused: "red", note: "amber", edit: "blue", fault: "red" };

function drawMark(context, { kind }, u, v) {
  context.fillStyle = context.strokeStyle = themeColor(COLORS[kind]);
  context.lineWidth = 2;
  context.beginPath();
  if (kind === "pause") {
    context.fillRect(u - 3.5, v - 4, 2.5, 8);
    context.fillRect(u + 1, v - 4, 2.5, 8);
  } else if (kind === "action") {
    context.fillRect(u - 4, v - 4, 8, 8);
  } else if (kind === "granted") {
    context.moveTo(u - 5.5, v + 5);
    context.lineTo(u + 5.5, v + 5);
    context.lineTo(u, v - 5.5);
    context.fill();
  } else if (kind === "refused" || kind === "fault") {
    context.moveTo(u - 4.5, v - 4.5);
    context.lineTo(u + 4.5, v + 4.5);
    context.moveTo(u + 4.5, v - 4.5);
    context.lineTo(u - 4.5, v + 4.5);
    context.stroke();
  } else if (kind === "edit") {
    context.moveTo(u, v - 5.5);
    context.lineTo(u + 5.5, v);
    context.lineTo(u, v + 5.5);
    context.lineTo(u - 5.5, v);
    context.fill();
  } else {
    context.arc(u, v, 4.5, 0, 2 * Math.PI);
    context.fill();
  }
}

export function drawAxis(context, top, range, x, width) {
  const [from, to] = range;
  const most = Math.max(2, (width - GUTTER) / 80);
  const step = TICKS.find((tick) => (to - from) / tick <= most) ?? 600;
  context.textAlign = "center";
  context.textBaseline = "top";
  for (let i = Math.ceil(from / step); i * step <= to; ++i) {
    const u = x(i * step);
    context.fillStyle = themeColor("rule");
    context.fillRect(u, top, 1, 4);
    if (u > width - 22 || u < GUTTER + 4) continue;
    context.fillStyle = themeColor("soft");
    context.fillText(`${Number((i * step).toFixed(1))} s`, u, top + 6);
  }
}

/// The height that these tracks need.
export const bandsHeight = (machines) => (3 + machines.length) * ROW + AXIS;

export function drawBands(context, store, machines, range, width, isDark) {
  const [from, to] = range;
  const x = (time) => GUTTER + ((time - from) / (to - from)) * (width - GUTTER - RIGHT);
  context.font = FONT;
  context.textBaseline = "middle";
  const rows = ["status", ...machines];
  rows.forEach((name, row) => {
    drawLabel(context, name.replaceAll("_", " "), (row + 0.5) * ROW);
    const band = store.bands.get(name);
    if (band) drawBand(context, band, row, range, x, isDark, row === 0, store.newest);
  });
  ["commands", "edits, notes"].forEach((name, i) => {
    const middle = (rows.length + i + 0.5) * ROW;
    drawLabel(context, name, middle);
    context.fillStyle = themeColor("rule");
    context.fillRect(GUTTER, middle - 0.5, width - GUTTER - RIGHT, 1);
  });
  for (const mark of marksOf(store)) {
    if (mark.time < from || mark.time > to) continue;
    drawMark(context, mark, x(mark.time), (rows.length + mark.row + 0.5) * ROW);
  }
  drawAxis(context, (rows.length + 2) * ROW, range, x, width);
}
