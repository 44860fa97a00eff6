// SPDX-License-Identifier: MIT
// The robot as the panels see it: the store, the parameters, the state of the connection, and what can be sent.
import { Connection } from "./connection.js";
import { Parameters } from "./parameters.js";
import { playbackRequest, seconds } from "./protocol.js";
import { Store, TOPICS } from "./store.js";
import { changed, changedByUser, onFailure } from "./ticker.js";

const SLOW = "Send buffer limit reached"; // the text of the protocol for a client that is too slow
const ENDED = "the run has ended"; // begins the reason with which a run ends the connection
const RATE = "slow"; // id of the status with reduced rates, and their cause
const SET = "set_parameters"; // a service
const ACCESS = "access"; // id of the status that says why this page may change nothing
const NOTICE = 15000; // ms for which a status without an id is shown

export const store = new Store(changed, changedByUser);
onFailure((error) => store.fail(error.message));
export const parameters = new Parameters(changed, changedByUser);

/// state: connecting, open or closed; since: Date.now() of its last change; notices: what the server reports; refusal:
/// why this page may change nothing; slow: reduced rates and their cause; framed: Date.now() of the last frame.
export const link = {
  state: "connecting",
  since: Date.now(),
  refusal: "",
  drops: 0,
  lastDrop: 0,
  slow: "",
  framed: 0,
  notices: new Map(),
  heard: 0,
  services: new Set(),
};

let connection = null;
let session = null;
let forget = () => {};
let playback = () => {};
let nextId = 1;
let subscribed = false;

const listeners = {
  state(state) {
    if (state !== link.state) link.since = Date.now();
    link.state = state;
    if (state !== "open") {
      link.services = new Set();
      link.slow = "";
      parameters.forgetSent();
    }
    if (state === "open" && connection.has("parameters"))
      connection.send({ op: "getParameters", parameterNames: [], id: "all" });
    subscribed = false;
  },
  server(info) {
    document.title = info.name;
    link.notices.clear();
    link.refusal = "";
    link.slow = "";
    if (session !== null && info.sessionId !== session) {
      store.clear();
      forget();
    }
    session = info.sessionId;
    store.isReplay = isReplay();
    parameters.begin(session);
  },
  services(services) {
    link.services = new Set(services.keys());
    if (link.services.has("parameter_list")) loadParameters();
  },
  message({ topic, time, payload }) {
    link.heard = Date.now();
    if (topic === "/world") link.framed = link.heard;
    store.receive(topic, time, payload);
    if (topic === "/parameters") parameters.takeTexts(store.lasting.get(topic)?.parameters ?? []);
  },
  parameters({ parameters: list, id }) {
    parameters.take(list, id);
    if (!subscribed && connection.has("parametersSubscribe")) {
      connection.send({ op: "subscribeParameterUpdates", parameterNames: list.map((it) => it.name) });
      subscribed = true;
    }
  },
  status(message) {
    if (message.op === "removeStatus") {
      for (const id of message.statusIds) link.notices.delete(id);
      if (message.statusIds.includes(RATE)) link.slow = "";
    } else if (message.message === SLOW) {
      ++link.drops;
      link.lastDrop = Date.now();
    } else if (message.id === RATE) {
      link.slow = message.message;
    } else if (message.id === ACCESS) {
      link.refusal = message.message;
    } else {
      link.notices.set(message.id ?? message.message, {
        ...message,
        until: message.id ? Infinity : Date.now() + NOTICE,
      });
    }
  },
  playback(state) {
    playback(state);
  },
  bad(text) {
    store.fail(text);
  },
};

/// Sets what is called with the state of a replay: status, time in s, speed.
export function onPlayback(call) {
  playback = call;
}

/// Sets what is called when another run begins.
export function onOtherRun(call) {
  forget = call;
}

export function connect(url) {
  connection = new Connection(url, TOPICS, (name, value) => {
    listeners[name](value);
    changed();
  });
}

async function loadParameters() {
  try {
    parameters.take((await connection.call("parameter_list", {})).parameters);
  } catch (error) {
    link.notices.set("parameter_list", { level: 1, message: `The list of parameters is missing: ${error.message}` });
    changed();
  }
}

export const canSetParameters = () =>
  link.state === "open" && !link.refusal && (connection.has("parameters") || canCall(SET));
/// Whether the robot offers a service; `changes`: one that changes something.
export const canCall = (service, changes = false) => link.services.has(service) && !(changes && link.refusal);
/// Why nothing is known about what the robot offers; empty: it is connected.
export function whyGone() {
  if (link.state === "closed")
    return runEnd() ? `${runEnd()}.` : "The robot is gone. The page connects again by itself.";
  if (link.state === "connecting") return "Connecting to the robot…";
  return link.services.size || !connection.has("services") ? "" : "Waiting for the robot…";
}
/// The end of the run, and who ended it, as a text without a full stop; empty: the run did not report its end.
export function runEnd() {
  const reason = connection?.reason ?? "";
  return reason.startsWith(ENDED) ? reason.replace(ENDED, "The run has ended") : "";
}
/// Whether the robot is a recording with a time bar.
export const isReplay = () => connection?.has("playbackControl") ?? false;
/// Sends a request of playbackRequest().
export const sendPlayback = (request) => connection.sendBinary(playbackRequest(request));
/// The first and the last time of the data of a replay: [s, s], or null.
export function dataRange() {
  const { dataStartTime: start, dataEndTime: end } = connection.server ?? {};
  return start && end ? [seconds(start), seconds(end)] : null;
}
export const call = (service, value, timeout) => connection.call(service, value, timeout);
/// Sets whether the run is paused, so that no frames arrive.
export function setPaused(isPaused) {
  store.isStill = isPaused;
  connection.isPaused = isPaused;
}

/// Sends a value of a parameter. The answer contains the value that is in force.
export function setParameter(name, value, undo = true) {
  const id = `set-${nextId++}`;
  const message = parameters.change(name, value, id, undo);
  if (connection.has("parameters")) connection.send(message);
  else callSetParameters(message.parameters, id);
}

/// For a robot that has the service instead of the capability.
async function callSetParameters(list, id) {
  try {
    parameters.take((await connection.call(SET, { parameters: list })).parameters ?? list, id);
  } catch (error) {
    link.notices.set(SET, { level: 1, message: `The parameter was not set: ${error.message}` });
    changed();
  }
}

export function undoParameter() {
  const undo = parameters.takeUndo();
  if (undo) setParameter(undo.name, undo.value, false);
  return undo;
}

/// Thresholds of the evidence, as the store has them.
export const limits = () => store.limits;
