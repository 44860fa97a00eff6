// SPDX-License-Identifier: MIT
// Both futures of a what-if on one time axis: evidence, status, the states that differ, and the commands.
import { AXIS, FONT, ROW, drawAxis, drawBand, drawLabel } from "./bands.js";
import { endOf, markText, marksOf, positionOf, ticksOf } from "./evidence_scale.js";
import { themeColor } from "./palette.js";
import { GUTTER, RIGHT } from "./plots.js";

const MOST_MACHINES = 4;
const APART = 13; // pixels between two labels
const MARGIN = 6; // pixels above and below the axis, for half a label
const DASHES = [6, 4];

/// The machines whose states differ, the first difference first.
export function differingMachines(answer) {
  const names = new Set(answer.states.filter((it) => it.recorded !== it.tried).map((it) => it.machine));
  return [...names].slice(0, MOST_MACHINES);
}

/// The height of the bands below the evidence.
export const trialBandsHeight = (answer) => (3 + 2 * differingMachines(answer).length) * ROW + AXIS;

const bandOf = (answer, machine, run) =>
  answer.states.filter((it) => it.machine === machine && it[run]).map((it) => ({ time: it.time, value: it.state }));

function statusBand(answer, run) {
  const band = [];
  answer[run].status.forEach((value, i) => {
    if (value !== band.at(-1)?.value) band.push({ time: answer.time[i], value });
  });
  return band;
}

function drawCurve(context, times, values, x, y) {
  context.beginPath();
  for (let i = 0; i < times.length; ++i) context.lineTo(x(times[i]), y(values[i]));
  context.stroke();
}

function drawEvidence(context, answer, limit, x, width, height) {
  const sizes = [answer.recorded, answer.tried].flatMap(({ evidence }) => evidence.map(Math.abs));
  const end = endOf(0, Math.max(...sizes, 0));
  const long = height - 2 * MARGIN;
  const y = (value) => MARGIN + long * (0.5 - 0.5 * positionOf(value, end));
  for (const mark of marksOf(end, long, APART)) {
    context.fillStyle = themeColor("rule");
    context.fillRect(GUTTER, y(mark), width - GUTTER - RIGHT, 1);
    context.fillStyle = themeColor("soft");
    context.textAlign = "right";
    context.fillText(markText(mark), GUTTER - 6, y(mark));
  }
  context.fillStyle = themeColor("gray");
  for (const tick of ticksOf(end, long)) context.fillRect(GUTTER - 3, y(tick), 3, 1);
  drawLabel(context, "evidence", height / 2 - 7);
  drawLabel(context, "(log scale)", height / 2 + 7);
  context.lineWidth = 1;
  context.setLineDash([2, 3]);
  for (const [value, color] of limit ? [[limit.unconfirmed, "mirrored"], [-limit.unconfirmed, "belief"]] : []) {
    context.strokeStyle = themeColor(color);
    drawCurve(context, [answer.from, answer.to], [value, value], x, y);
  }
  context.setLineDash([]);
  context.lineWidth = 2;
  context.strokeStyle = themeColor("evidence");
  drawCurve(context, answer.time, answer.recorded.evidence, x, y);
  context.strokeStyle = themeColor("amber");
  context.setLineDash(DASHES);
  drawCurve(context, answer.time, answer.tried.evidence, x, y);
  context.setLineDash([]);
}

/// A command: a triangle upward of the robot, downward of the trial; of both: a rhombus.
function drawCommand(context, { recorded, tried }, u, v) {
  context.fillStyle = themeColor(recorded && tried ? "gray" : recorded ? "ink" : "amber");
  context.beginPath();
  if (recorded) {
    context.moveTo(u - 5, v);
    context.lineTo(u + 5, v);
    context.lineTo(u, v - 7);
  }
  context.fill();
  context.beginPath();
  if (tried) {
    context.moveTo(u - 5, v + 1);
    context.lineTo(u + 5, v + 1);
    context.lineTo(u, v + 8);
  }
  context.fill();
}

export const isCommand = ({ text }) => /: \w+, (granted|refused)/.test(text);

export function drawTrial(context, answer, limit, width, height, isDark) {
  const range = [answer.from, Math.max(answer.to, answer.from + 0.1)];
  const x = (time) => GUTTER + ((time - range[0]) / (range[1] - range[0])) * (width - GUTTER - RIGHT);
  const machines = differingMachines(answer);
  const upper = Math.max(40, height - trialBandsHeight(answer));
  context.font = FONT;
  context.textBaseline = "middle";
  if (answer.guess_from !== null) {
    context.fillStyle = themeColor("rule");
    context.globalAlpha = 0.45;
    context.fillRect(x(answer.guess_from), 0, width - RIGHT - x(answer.guess_from), height - AXIS);
    context.globalAlpha = 1;
    context.fillStyle = themeColor("soft");
    context.textAlign = "right";
    if (width - x(answer.guess_from) > 50) context.fillText("a guess", width - RIGHT - 5, 9);
  }
  drawEvidence(context, answer, limit, x, width, upper);
  context.save();
  context.translate(0, upper);
  const rows = [["status", "recorded", statusBand(answer, "recorded"), true], ["status", "tried", statusBand(answer, "tried"), true]];
  for (const machine of machines)
    for (const run of ["recorded", "tried"]) rows.push([machine.replaceAll("_", " "), run, bandOf(answer, machine, run), false]);
  rows.forEach(([name, run, band, isStatus], row) => {
    drawLabel(context, run === "recorded" ? name : "  what if", (row + 0.5) * ROW);
    drawBand(context, band, row, range, x, isDark, isStatus);
  });
  const middle = (rows.length + 0.5) * ROW;
  drawLabel(context, "commands", middle);
  context.fillStyle = themeColor("rule");
  context.fillRect(GUTTER, middle, width - GUTTER - RIGHT, 1);
  for (const event of answer.events.filter(isCommand)) drawCommand(context, event, x(event.time), middle);
  drawAxis(context, (rows.length + 1) * ROW, range, x, width);
  context.restore();
  if (answer.first_decision) {
    context.fillStyle = themeColor("red");
    context.fillRect(x(answer.first_decision.time) - 0.75, 0, 1.5, height - AXIS);
  }
}
