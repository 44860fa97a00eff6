// SPDX-License-Identifier: MIT
// The keys of the page. Keys typed into a field are left alone, except Escape.
import { openPanel } from "./layout.js";
import { runOneFrame, togglePause } from "./pace.jsx";
import { panels } from "./panels/index.js";
import { store, undoParameter } from "./robot.js";
import { switchTheme } from "./theme.js";

export const KEYS = [
  ["Space", "pause the view, or back to live; the robot continues"],
  ["← →", "one frame back or forward; with Shift one second"],
  ["L", "back to live"],
  ["1 … 9, 0, O, W", "open a panel"],
  ["P", "pause or resume the run, if its pace can be set"],
  [".", "run one frame of a paused run"],
  ["/", "search in parameters, world, log or scripts"],
  ["N", "write a note"],
  ["U", "undo the last change of a parameter"],
  ["T", "colors: as the system, light, dark"],
  ["A", "audience view, and back"],
  ["?", "show or hide these keys"],
  ["Ctrl-S", "save the open script"],
  ["wheel", "in the timeline: zoom; with Shift: move"],
];

const SECOND = 1;

function move(event, direction) {
  if (event.shiftKey) store.show((store.shown()?.time ?? 0) + direction * SECOND);
  else store.step(direction);
}

/// Focuses an element once it is drawn.
function focusSoon(selector, attempts = 10) {
  requestAnimationFrame(() => {
    const element = document.querySelector(selector);
    if (element) element.focus();
    else if (attempts > 0) focusSoon(selector, attempts - 1);
  });
}

/// `actions`: help(), close().
export function onKey(event, actions) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const { target } = event;
  if (event.key === "Escape") {
    target.blur?.();
    actions.close();
    return;
  }
  const isTyping = target.matches?.("input:not([type=range]):not([type=checkbox]), textarea, select");
  if (isTyping || (target.matches?.("input[type=range]") && event.key.startsWith("Arrow"))) return;
  if (event.key === " " && target.matches?.("button:not(#pause), summary, input")) return;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  const panel = panels.find((it) => it.key === key);
  const handlers = {
    " ": () => store.show(store.isLive ? store.newest : null),
    l: () => store.show(null),
    ArrowLeft: () => move(event, -1),
    ArrowRight: () => move(event, 1),
    t: switchTheme,
    u: undoParameter,
    p: togglePause,
    ".": runOneFrame,
    a: () => {
      location.hash = location.hash === "#audience" ? "" : "#audience";
    },
    n: () => {
      openPanel("notes");
      focusSoon("#note");
    },
    "/": () => {
      if (!document.querySelector("input[type=search]")) openPanel("parameters");
      focusSoon("input[type=search]");
    },
    "?": actions.help,
  };
  const handler = panel
    ? () => openPanel(panel.id)
    : handlers[key];
  if (!handler) return;
  event.preventDefault();
  handler();
}
