// SPDX-License-Identifier: MIT
// The one store of what the robot sent: the frames of the last 10 minutes, what happened in them, and which instant the
// panels show. Times are seconds of the robot.
import { FRAME_SIZE, IMAGE_TOPICS, fit, sizeOf } from "./memory.js";
import { readJson, seconds } from "./protocol.js";

export const TOPICS = [
  "/field",
  "/wall",
  "/room",
  "/percepts",
  "/belief/particles",
  "/truth/pose",
  "/world",
  "/machines",
  "/conditions",
  "/events",
  "/request",
  "/log",
  "/costs",
  "/parameters",
  "/decision",
  "/camera/upper/image",
  "/camera/upper/calibration",
  "/camera/upper/annotations",
  "/camera/lower/image",
  "/camera/lower/calibration",
  "/camera/lower/annotations",
];
const LONGEST = 600; // s
const BUDGET = 256e6; // bytes
const GAP = 1; // s between two frames, in which the states are not known
const FRAME = 1 / 30; // s
const MOST_LINES = 5000; // of the log, and of events
const PARSED = 48; // parsed messages that are kept
const LASTING = new Set([
  "/field",
  "/parameters",
  "/decision",
  "/camera/upper/calibration",
  "/camera/lower/calibration",
]);
const MICROSECOND = 1e-6;

function binaryOf(base64) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(base64);
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

/// An entry of the timeline from a message of /events.
export function eventOf(time, message) {
  const { machine, state, command, verdict, reason } = message;
  if (command)
    return { time, kind: "command", machine, state, command, verdict, granted: verdict === "granted", reason };
  if (state.startsWith("note: ")) return { time, kind: "note", machine, text: state.slice(6), reason };
  const at = state.indexOf("> ");
  if (at < 0) return { time, kind: "game", machine, text: state, reason };
  return { time, kind: "transition", machine, from: state.slice(0, at).trim(), to: state.slice(at + 2), reason };
}

/// What a frame lacks of image and detections, and why, as text; empty: nothing.
export function missingOf(frame) {
  if (!frame) return "";
  const has = (name) => Object.keys(frame.parts).some((topic) => topic.endsWith(name));
  const names = [
    ["/image", "image"],
    ["/percepts", "detections"],
  ];
  const missing = names.filter(([topic]) => !has(topic)).map(([, name]) => name);
  if (!missing.length) return "";
  return `no ${missing.join(", no ")} of this frame (${frame.thinned ? "dropped to save memory" : "not received"})`;
}

export class Store {
  constructor(onChange = () => {}, onShow = onChange, budget = BUDGET) {
    this.onChange = onChange;
    this.onShow = onShow;
    this.budget = budget;
    this.bad = 0; // messages that could not be read or drawn
    this.badText = "";
    this.isReplay = false; // the time may go back, to frames that are then sent again
    this.isStill = false; // the run is paused, so that the newest frame is complete
    this.clear();
  }

  /// Forgets everything that was received, for example because another run began.
  clear() {
    this.run = (this.run ?? 0) + 1; // what belongs to the data of before is not valid any more
    this.frames = [];
    this.size = 0;
    this.events = [];
    this.log = [];
    this.bands = new Map(); // "status" or the name of a machine: [{time, value}], one entry a change
    this.scenario = new Set(); // names of the machines of the scenario
    this.lasting = new Map(); // topic: message
    this.parsed = new Map();
    this.instant = null; // s; null: live
    this.worldTime = null; // s, of the last message of /world
    this.droppedFrames = 0;
    this.onChange();
  }

  /// Counts what could not be read or drawn, and keeps the last text.
  fail(text) {
    ++this.bad;
    this.badText = text;
  }

  /// Takes a message. `time`: microseconds.
  receive(topic, time, payload) {
    try {
      this.take(topic, time * MICROSECOND, payload);
    } catch (error) {
      this.fail(`${topic}: ${error.message}`);
    }
    this.onChange();
  }

  take(topic, time, payload) {
    if (LASTING.has(topic)) {
      this.lasting.set(topic, readJson(payload));
      return;
    }
    if (topic === "/world") this.beginFrame(time);
    if (topic === "/events") {
      this.addLine(this.events, eventOf(time, readJson(payload)));
      return;
    }
    if (topic === "/log") {
      this.addLine(this.log, { time, ...readJson(payload) });
      return;
    }
    const frame = this.frameAt(time);
    let part = payload;
    if (topic === "/world") this.takeWorld(frame, readJson(payload));
    if (topic === "/machines")
      for (const { name, state, scenario } of readJson(payload).machines) {
        this.addBand(name, time, state);
        if (scenario) this.scenario.add(name);
      }
    if (topic === "/truth/pose") {
      const { position, orientation } = readJson(payload).pose;
      frame.truth = { x: position.x, y: position.y, rotation: 2 * Math.atan2(orientation.z, orientation.w) };
      part = null;
    }
    if (IMAGE_TOPICS.includes(topic)) {
      const message = readJson(payload);
      part = { bytes: binaryOf(message.data), time: seconds(message.timestamp), format: message.format };
    }
    if (part === null) return;
    if (frame.parts[topic]) this.size -= sizeOf(frame.parts[topic]);
    frame.parts[topic] = part;
    this.size += sizeOf(part);
    this.bound();
  }

  /// Before the world of a frame: the time may have gone back, or frames may be missing.
  beginFrame(time) {
    const last = this.worldTime;
    if (last !== null && this.isReplay && time < last) this.rewind(time);
    else if (last !== null && time < this.newest - LONGEST) this.clear();
    else if (last !== null && time - last > GAP) this.endBands(last + FRAME);
    this.worldTime = time;
  }

  takeWorld(frame, world) {
    const { pose = {}, confidence = {}, robot = {} } = world;
    frame.pose = { x: pose.x, y: pose.y, rotation: pose.rotation };
    frame.known = pose.known !== false;
    frame.evidence = confidence.evidence;
    frame.current = confidence.current;
    frame.opposite = confidence.opposite;
    frame.headYaw = robot.head_yaw ?? 0;
    this.addBand("status", frame.time, confidence.status ?? "");
  }

  addBand(name, time, value) {
    let band = this.bands.get(name);
    if (!band) this.bands.set(name, (band = []));
    if (band.at(-1)?.value !== value) band.push({ time, value });
  }

  /// The states are not known from a time on.
  endBands(time) {
    for (const band of this.bands.values()) if (band.at(-1)?.value) band.push({ time, value: "" });
  }

  addLine(list, line) {
    list.push(line);
    if (list.length > MOST_LINES) list.splice(0, MOST_LINES / 10);
  }

  /// The frame of this time, which is made if it is missing.
  frameAt(time) {
    const index = this.indexAt(time);
    const found = this.frames[index];
    if (found && found.time === time) return found;
    const frame = { time, parts: {}, pose: null, truth: null, thinned: false };
    this.frames.splice(index + 1, 0, frame);
    this.size += FRAME_SIZE;
    return frame;
  }

  /// A replay continues at an earlier time: forgets what was received after it.
  rewind(time) {
    for (const frame of this.frames.splice(this.indexAt(time) + 1)) {
      for (const part of Object.values(frame.parts)) this.size -= sizeOf(part);
      this.size -= FRAME_SIZE;
    }
    const isBefore = (entry) => entry.time < time - MICROSECOND;
    this.events = this.events.filter(isBefore);
    this.log = this.log.filter(isBefore);
    for (const band of this.bands.values()) while (band.length && !isBefore(band.at(-1))) band.pop();
    if (this.instant !== null) this.instant = Math.min(this.instant, time);
  }

  bound() {
    const newest = this.frames.at(-1).time;
    let drop = 0;
    while (this.frames[drop].time < newest - LONGEST) {
      for (const part of Object.values(this.frames[drop].parts)) this.size -= sizeOf(part);
      this.size -= FRAME_SIZE;
      ++drop;
    }
    this.drop(drop);
    if (this.size <= this.budget) return;
    const fitted = fit(this.frames, this.size, this.budget);
    this.size = fitted.size;
    this.drop(fitted.drop);
  }

  drop(count) {
    if (!count) return;
    this.frames.splice(0, count);
    this.droppedFrames += count;
    const oldest = this.frames[0]?.time ?? 0;
    for (const band of this.bands.values()) while (band.length > 1 && band[1].time <= oldest) band.shift();
    for (const list of [this.events, this.log]) while (list.length && list[0].time < oldest) list.shift();
  }

  /// The index of the last frame at or before a time, -1 before the first frame.
  indexAt(time) {
    const { frames } = this;
    let low = 0;
    let high = frames.length;
    if (high && frames[high - 1].time <= time) return high - 1;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (frames[middle].time <= time) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }

  get newest() {
    return this.frames.at(-1)?.time ?? 0;
  }

  /// Thresholds of the evidence in log-odds, {confirmed, unconfirmed}; null: the robot has not sent them.
  get limits() {
    const { confirmed, unconfirmed } = this.lasting.get("/decision") ?? {};
    return [confirmed, unconfirmed].every(Number.isFinite) ? { confirmed, unconfirmed } : null;
  }

  get isLive() {
    return this.instant === null;
  }

  /// The index of the frame that the panels show, -1 before the first. Live, it is the last complete one.
  shownIndex() {
    if (this.instant !== null) return Math.max(0, Math.min(this.indexAt(this.instant), this.frames.length - 1));
    return this.frames.length > 1 && !this.isStill ? this.frames.length - 2 : this.frames.length - 1;
  }

  shown() {
    return this.frames[this.shownIndex()];
  }

  /// Shows an instant; null: follows the robot.
  show(time) {
    this.instant =
      time === null || !this.frames.length ? null : Math.min(Math.max(time, this.frames[0].time), this.newest);
    this.onShow();
  }

  /// Keeps the frame that is shown live. The newest would lack the messages that still come.
  hold() {
    const shown = this.shown();
    if (this.isLive && shown) this.show(shown.time);
  }

  /// Holds the shown frame, or follows the robot again.
  toggleHold() {
    if (this.isLive) this.hold();
    else this.show(null);
  }

  /// Shows the frame `count` after the shown one.
  step(count) {
    const index = Math.max(0, Math.min(this.shownIndex() + count, this.frames.length - 1));
    if (this.frames[index]) this.show(this.frames[index].time);
  }

  /// The last part of a topic at or before the shown frame, at most `within` s old: {part, time}, or null.
  latest(topic, within = 2) {
    const index = this.shownIndex();
    if (index < 0) return null;
    const oldest = this.frames[index].time - within;
    for (let i = index; i >= 0 && this.frames[i].time >= oldest - 1e-6; --i) {
      const part = this.frames[i].parts[topic];
      if (part) return { part, time: this.frames[i].time };
    }
    return null;
  }

  /// The parsed message of a part.
  parse(part) {
    let value = this.parsed.get(part);
    if (value === undefined) {
      value = readJson(part);
      if (this.parsed.size >= PARSED) this.parsed.delete(this.parsed.keys().next().value);
      this.parsed.set(part, value);
    }
    return value;
  }

  /// The parsed last message of a topic, as `latest` finds it: {value, time}, or null.
  read(topic, within = 2) {
    const found = this.latest(topic, within);
    return found && { value: this.parse(found.part), time: found.time };
  }
}
