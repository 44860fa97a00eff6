// SPDX-License-Identifier: MIT
// The operator beside the field, and the pace of the run: what this run offers, and the requests of this page.
import { call, canCall, isReplay, link, store } from "./robot.js";
import { changed, changedByUser } from "./ticker.js";

const POLL = 1000; // ms

/// What the run offers, as the service run_state answers: operator, pace, paused, speed. problem: the last refusal.
export const run = { operator: false, pace: false, paused: false, speed: 1, problem: "" };

let isAsking = false;

function take(answer) {
  Object.assign(run, answer);
  store.isStill = run.paused;
}

async function refresh() {
  if (isAsking || !canCall("run_state")) return;
  isAsking = true;
  try {
    take(await call("run_state", {}));
    changed();
  } catch {
    // The connection shows why.
  } finally {
    isAsking = false;
  }
}

/// Follows the state of the run, which other viewers and the prompt change too. Returns a function that ends this.
export function followRun() {
  const timer = setInterval(refresh, POLL);
  const begin = setTimeout(refresh, POLL / 5);
  return () => {
    clearInterval(timer);
    clearTimeout(begin);
  };
}

/// The run is paused, so that no frames arrive.
export const isRunPaused = () => link.state === "open" && run.paused;

async function request(service, value) {
  try {
    const answer = await call(service, value);
    run.problem = "";
    if (service === "pace") take(answer);
    return true;
  } catch (error) {
    run.problem = error.message;
    return false;
  } finally {
    changedByUser();
  }
}

/// An action of the operator. Resolves to whether the run accepted it; if not, run.problem says why.
export const act = (action, values = {}) => request("operator", { action, ...values });
export const place = (pose, action = "put_down") =>
  act(action, { x: pose.x, y: pose.y, degrees: (180 / Math.PI) * pose.rotation });
/// A change of the pace: pause, resume, frame, speed.
export const setPace = (action, values = {}) => request("pace", { action, ...values });

export const canSetPace = () => run.pace && canCall("pace", true);
export const canOperate = () => run.operator && canCall("operator", true);
/// The true robot can be dragged: the panels show the present.
export const canCarry = () => canOperate() && store.isLive && link.state === "open";

/// Why this page cannot act as the operator, as one sentence; empty: it can.
export function whyNoOperator() {
  if (link.refusal) return link.refusal;
  if (isReplay()) return "A replay has no operator.";
  if (!canCall("operator")) return "This robot takes no actions of the operator from the page.";
  if (!run.operator) return "This program cannot lift or place this robot. Only the simulator has an operator.";
  return "";
}
