// SPDX-License-Identifier: MIT
// Draws what changed: each subscriber is called at most once an interval, on a frame of the display, after a change.
import { useEffect, useRef, useState } from "preact/hooks";

const subscribers = new Set();
let failed = () => {};

/// Sets what is called with the error of a drawing.
export function onFailure(call) {
  failed = call;
}

let version = 0;
let scheduled = 0;
let urgent = false;

/// Marks that something changed that panels show.
export function changed() {
  ++version;
  schedule();
}

/// The same for what the user did: everything is drawn on the next frame of the display.
export function changedByUser() {
  urgent = true;
  changed();
}

function schedule() {
  if (!scheduled) scheduled = requestAnimationFrame(run);
}

function run(now) {
  scheduled = 0;
  let late = false;
  const isUrgent = urgent;
  urgent = false;
  for (const subscriber of subscribers) {
    if (subscriber.seen === version) continue;
    if (!isUrgent && now - subscriber.last < subscriber.interval - 4) {
      late = true;
      continue;
    }
    subscriber.seen = version;
    subscriber.last = now;
    try {
      subscriber.call(now);
    } catch (error) {
      failed(error); // the other panels are drawn
    }
  }
  if (late) schedule();
}

/// Calls `call` after changes, at most once in `interval` ms. Returns a function that ends this.
export function onChange(interval, call) {
  const subscriber = { interval, call, last: -1e9, seen: -1 };
  subscribers.add(subscriber);
  changed();
  return () => subscribers.delete(subscriber);
}

/// Renders a component again after changes, at most once in `interval` ms.
export function useChanges(interval) {
  const [, render] = useState(0);
  const count = useRef(0);
  useEffect(() => onChange(interval, () => render(++count.current)), [interval]);
}
