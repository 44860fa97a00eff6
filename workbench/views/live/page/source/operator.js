// SPDX-License-Identifier: MIT
// The operator beside the field, and the pace of the run: what this run offers, and the requests of this page.
import { mirrored } from "./draw/field.js";
import { call, canCall, isReplay, link, setPaused, store, whyGone } from "./robot.js";
import { changed, changedByUser } from "./ticker.js";

const POLL = 1000; // ms

/// What the run offers, as the service run_state answers: operator, pace, paused, speed. problem: the last refusal.
export const run = { operator: false, pace: false, paused: false, speed: 1, problem: "" };

let isAsking = false;
let placed = null; // where this page placed the robot: {pose, after: s, run}

function take(answer) {
  Object.assign(run, answer);
  if (!isReplay()) setPaused(run.paused);
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

/// Where this page placed the true robot, until a frame shows it; null: as the frames show it.
export function placedPose() {
  const shown = store.shown();
  const isOver = placed && (placed.run !== store.run || (store.isLive && shown?.time > placed.after));
  if (isOver) placed = null;
  return store.isLive ? (placed?.pose ?? null) : null;
}

/// The run is paused, so that no frames arrive.
export const isRunPaused = () => link.state === "open" && run.paused;

async function request(service, value) {
  try {
    const answer = await call(service, value);
    run.problem = "";
    if (service === "pace") take(answer);
    return answer;
  } catch (error) {
    run.problem = error.message;
    return null;
  } finally {
    changedByUser();
  }
}

/// An action of the operator. Resolves to the answer, or to null if the run refused it; then run.problem says why.
export const act = (action, values = {}) => request("operator", { action, ...values });

/// An action that places the true robot at `pose` before the next frame.
async function placeBy(pose, action, values) {
  const mine = { pose, after: Infinity, run: store.run };
  placed = mine;
  const answer = await act(action, values);
  // The answer has the time of the last frame before the action.
  if (answer) mine.after = answer.time;
  else if (placed === mine) placed = null;
}

const valuesOf = ({ x, y, rotation }) => ({ x, y, degrees: (180 / Math.PI) * rotation });
/// Places the true robot.
export const place = (pose) => placeBy(pose, "put_down", valuesOf(pose));
/// Places the true robot at the mirrored pose of its true pose.
export function mirrorRobot() {
  const pose = placedPose() ?? store.shown()?.truth;
  return pose && store.isLive ? placeBy(mirrored(pose), "mirror") : act("mirror");
}
/// Gives the robot a pose as its belief.
export const setInitialPose = (pose) => act("set_initial_pose", valuesOf(pose));
/// A change of the pace: pause, resume, frame, speed.
export const setPace = (action, values = {}) => request("pace", { action, ...values });

export const canSetPace = () => run.pace && canCall("pace", true);
export const canOperate = () => run.operator && canCall("operator", true);
/// The true robot can be dragged: the panels show the present.
export const canCarry = () => canOperate() && store.isLive && link.state === "open";

/// Why this page cannot act as the operator, as one sentence; empty: it can.
export function whyNoOperator() {
  if (link.refusal) return link.refusal;
  if (whyGone()) return whyGone();
  if (isReplay()) return "A replay has no operator.";
  if (!canCall("operator")) return "This robot takes no actions of the operator from the page.";
  if (!run.operator) return "This program cannot lift or place this robot. Only the simulator has an operator.";
  return "";
}
