// SPDX-License-Identifier: MIT
// A what-if: changes that the robot does not have, and what it would have done with them in the last seconds.
import { call, canCall, link, onOtherRun, parameters, setParameter, store, whyGone } from "./robot.js";
import { changedByUser } from "./ticker.js";

const TIMEOUT = 120000; // ms; a slow computer may need long
const REPLACED = "replaced by a newer question";

/// isOn: sliders try values instead of setting them; seconds: length of the replayed time; answer: of the service
/// what_if, or null; failure: why it is missing.
export const trial = {
  isOn: false,
  seconds: 30,
  parameters: new Map(), // name: tried value
  scripts: new Map(), // file: tried text
  answer: null,
  failure: "",
  isAsking: false,
};

let show = () => {};
let asked = 0; // questions so far; only the answer to the last one counts

/// Sets what shows a panel: `call(id, enters)`; `enters`: and gives it the focus.
export function onTrial(call) {
  show = call;
}

export const canTry = () => canCall("what_if", true);
/// Why nothing can be tried, as one sentence; empty: it can.
export const whyNoTrial = () =>
  canTry() ? "" : link.refusal || whyGone() || "This robot keeps no frames, so it cannot answer what-if.";
export const isTrying = () => trial.parameters.size > 0 || trial.scripts.size > 0;

/// The end of the replayed time: now, or half of it after the shown instant. Nothing: the last frame.
const endOf = () => (store.isLive ? undefined : Math.min(store.newest, store.instant + trial.seconds / 2));

async function ask() {
  const question = ++asked;
  const request = { seconds: trial.seconds };
  const to = endOf();
  if (to !== undefined) request.to = to;
  if (trial.parameters.size) request.parameters = [...trial.parameters].map(([name, value]) => ({ name, value }));
  if (trial.scripts.size) request.scripts = [...trial.scripts].map(([file, text]) => ({ file, text }));
  trial.isAsking = true;
  changedByUser();
  let failure = "";
  let answer = null;
  try {
    answer = await call("what_if", request, TIMEOUT);
  } catch (error) {
    failure = error.message;
  }
  if (question !== asked || failure.includes(REPLACED)) return;
  Object.assign(trial, { isAsking: false, failure });
  if (answer) trial.answer = answer;
  changedByUser();
}

/// Asks for the present changes again.
export function askAgain() {
  if (isTrying()) ask();
  else clear();
}

function clear() {
  ++asked;
  Object.assign(trial, { answer: null, failure: "", isAsking: false });
  changedByUser();
}

export function setSeconds(seconds) {
  trial.seconds = seconds;
  askAgain();
}

/// Shows the answer, which is in another panel than the controls.
export const showAnswer = () => show("what_if", true);

/// Begins or ends a what-if of parameters: whether the controls of their panel try values instead of setting them. The
/// end drops the values that were tried. `enters`: whether the panel gets the focus.
export function switchTrial(enters = false) {
  trial.isOn = !trial.isOn;
  if (trial.isOn) {
    show("what_if", false);
    show("parameters", enters);
  } else if (trial.parameters.size) {
    trial.parameters.clear();
    askAgain();
  }
  changedByUser();
}

export function tryParameter(name, value) {
  trial.parameters.set(name, value);
  ask();
}

export function tryScript(file, text) {
  trial.scripts.set(file, text);
  show("what_if", false);
  ask();
}

export function dropParameter(name) {
  if (trial.parameters.delete(name)) askAgain();
}

export function dropScript(file) {
  if (trial.scripts.delete(file)) askAgain();
}

export function dropAll() {
  trial.parameters.clear();
  trial.scripts.clear();
  clear();
}

// The answer is that of the run before.
onOtherRun(() => {
  trial.isOn = false;
  dropAll();
});

/// Sets the tried parameters on the robot, and so do the sliders from now on. Scripts are saved in the editor.
export function applyParameters() {
  for (const [name, value] of trial.parameters) {
    setParameter(name, value);
    parameters.settle();
  }
  trial.parameters.clear();
  trial.isOn = false;
  askAgain();
}
