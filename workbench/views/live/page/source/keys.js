// SPDX-License-Identifier: MIT
// The keys of the page. Keys typed into a field are left alone, except Escape.
import { contentsOf, openPanel } from "./layout.js";
import { runOneFrame, togglePause } from "./pace.jsx";
import { panels } from "./panels/index.js";
import { store, undoParameter } from "./robot.js";
import { switchTheme } from "./theme.js";

export const KEYS = [
  ["Space", "pause the view, or back to live; the robot continues"],
  ["← →", "one frame back or forward; with Shift one second"],
  ["L", "back to live"],
  ["1 … 9, 0, O, W", "open a panel"],
  ["P", "pause or resume the run, if its pace can be set, or the replay"],
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

let typed = null; // letters for a box that is not drawn yet; null: no box is about to get the focus
let asked = 0; // number of the last element that shall get the focus; earlier ones no longer get it

/// Calls `use` with the element that `find` returns, now if it is drawn, else once it is; null: it was never drawn.
/// letters: "" to collect in `typed` what is typed until then.
function whenDrawn(find, use, letters = null) {
  const mine = ++asked;
  typed = letters;
  const look = (attempts) => {
    if (mine !== asked) return;
    const element = find();
    if (element || attempts === 0) use(element);
    else requestAnimationFrame(() => look(attempts - 1));
  };
  look(10);
}

/// Focuses a box. What is typed until it is drawn goes into it.
function focusBox(find) {
  const fill = (box) => {
    const letters = typed;
    typed = null;
    box?.focus();
    box?.select();
    if (!box || !letters) return;
    box.value = letters;
    box.dispatchEvent(new Event("input", { bubbles: true }));
  };
  whenDrawn(find, fill, "");
}

/// Opens a panel and gives it the focus, so that the next Tab goes to its first control.
export function enterPanel(id) {
  openPanel(id);
  whenDrawn(
    () => document.querySelector(`[data-panel=${id}]`),
    (panel) => panel?.focus(),
  );
}

const SEARCH = "input[type=search]";
/// The box for a search of the panel with the focus, else the first one. A panel that is about to be replaced has none.
function searchBox() {
  const areas = [document.activeElement?.closest("[data-panel]"), ...document.querySelectorAll("[data-panel]")];
  const open = areas.filter((it) => it && contentsOf(it.dataset.area).open?.id === it.dataset.panel);
  return open.map((it) => it.querySelector(SEARCH)).find((box) => box);
}

const AUDIENCE_KEYS = ["a", "t", "l", " ", "ArrowLeft", "ArrowRight"];

/// `actions`: help(), close(); isAudience(): the view is read-only.
export function onKey(event, actions) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const { target } = event;
  if (typed !== null && event.key.length === 1) {
    typed += event.key;
    event.preventDefault();
    return;
  }
  if (event.key === "Escape") {
    // Else Chrome empties a box for a search without an input event, and the next drawing fills it again.
    if (target.matches?.("input[type=search]")) event.preventDefault();
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
    " ": () => store.toggleHold(),
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
      focusBox(() => document.querySelector("#note"));
    },
    "/": () => {
      if (!searchBox()) openPanel("parameters");
      focusBox(searchBox);
    },
    "?": actions.help,
  };
  const handler = panel
    ? () => enterPanel(panel.id)
    : handlers[key];
  if (!handler || (actions.isAudience() && !AUDIENCE_KEYS.includes(key))) return;
  event.preventDefault();
  handler();
}
