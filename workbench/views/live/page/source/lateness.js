// SPDX-License-Identifier: MIT
// Why the robot sends fewer frames: whether this browser is busy, because a timer of the page fires much later than it
// should, and what the robot knows.

const INTERVAL = 200; // ms
const SPAN = 4000; // ms that count
const MOST_LATE = 0.08; // fraction of the span, of a browser that is not busy

const RECENT =
  "The robot sends fewer frames and images, so that what arrives is recent. Events and log lines all arrive.";
const UNKNOWN = "slow connection or busy viewer"; // with which the robot begins the status, as in server/rate_status.h
const EITHER = "slow connection or busy computer";
const CAUSES = {
  "busy computer": "The computer of the run is busy.",
  "busy browser": "This browser is busy: it processes messages late.",
  [EITHER]: "Messages wait: the connection is slow, or the computer of this browser is busy.",
};

export class Lateness {
  constructor() {
    this.reset();
  }

  /// What is known does not count any more. A hidden page has late timers, too.
  reset() {
    this.last = null; // ms, of the last call of tick()
    this.waits = []; // [{time, late}] in ms
  }

  /// The timer fired.
  tick(time) {
    if (this.last !== null) this.waits.push({ time, late: Math.max(0, time - this.last - INTERVAL) });
    this.last = time;
    while (this.waits.length && this.waits[0].time < time - SPAN) this.waits.shift();
  }

  get isBusy() {
    return this.waits.reduce((sum, { late }) => sum + Math.min(late, SPAN), 0) > MOST_LATE * SPAN;
  }
}

/// Follows this browser. Returns a function that ends this.
export function followBrowser(lateness) {
  const timer = setInterval(() => (document.hidden ? lateness.reset() : lateness.tick(performance.now())), INTERVAL);
  return () => clearInterval(timer);
}

/// The status of the robot with the cause that is known: {text, title}.
export function rateText(status, isBrowserBusy) {
  const text = status.replace(UNKNOWN, isBrowserBusy ? "busy browser" : EITHER);
  return { text, title: `${CAUSES[text.split(":")[0]] ?? ""} ${RECENT}`.trim() };
}
