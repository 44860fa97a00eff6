// SPDX-License-Identifier: MIT
// One sentence about what the robot thinks of its pose, from what it sent.

const RECENT = 5; // s after a command in which it is mentioned

const COMMANDS = {
  flip_pose: "The robot noticed that its believed pose was mirrored, and corrected it.",
  purge_reflection: "The robot is sure of its pose and removed the last mirrored hypotheses.",
  reset_orientation: "The robot got up and starts to find its orientation again.",
};

const STATUS = {
  off: "The robot does not use the colors of the room.",
  resting: "The robot does not compare the room at the moment.",
  unlearned: "The robot learns the colors of the room.",
  symmetric: "The room looks the same on both sides, so its colors cannot help.",
  lost: "The robot does not know where it is, and compares the room with what it has learned.",
  fresh: "The robot has just begun to compare the room with what it has learned.",
};

/// `tone`: good, doubt, wrong or busy.
export function thought(store, limits) {
  const found = store.read("/world");
  if (!found) return { text: "The robot has not sent anything yet.", tone: "busy" };
  const { robot = {}, pose = {}, confidence = {}, training = {} } = found.value;
  if (robot.posture === "lifted") return { text: "The robot is lifted.", tone: "busy" };
  if (robot.posture === "lying") return { text: "The robot fell and lies on the ground.", tone: "busy" };
  const now = found.time;
  for (let i = store.events.length - 1; i >= 0; --i) {
    const event = store.events[i];
    if (event.time < now - RECENT) break;
    if (event.time > now || event.kind !== "command" || !event.granted || !COMMANDS[event.command]) continue;
    return { text: COMMANDS[event.command], tone: event.command === "flip_pose" ? "wrong" : "good" };
  }
  const limit = limits?.unconfirmed ?? 4;
  const isUsable = confidence.status === "usable" || confidence.status === "lost";
  if (isUsable && confidence.evidence > limit)
    return { text: "The room supports the mirrored pose: the robot is probably wrong.", tone: "wrong" };
  if (isUsable && confidence.evidence < -limit) {
    const learns = training.active ? " It continues to learn the room." : "";
    return { text: `The robot is sure of its pose: the room agrees with it.${learns}`, tone: "good" };
  }
  if (pose.known === false && confidence.status !== "lost")
    return { text: "The robot does not know where it is.", tone: "doubt" };
  const isLearning = training.active && confidence.status === "resting";
  const text = STATUS[isLearning ? "unlearned" : confidence.status];
  if (text) return { text, tone: text === STATUS.unlearned ? "busy" : "doubt" };
  return { text: "The robot compares the room with what it has learned, and is not sure yet.", tone: "doubt" };
}
