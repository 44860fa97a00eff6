// SPDX-License-Identifier: MIT
// What the page remembers between visits: layout, layers, theme, pinned values. Kept in localStorage if it is
// available.
import { changedByUser } from "./ticker.js";

const KEY = "reorient.live.1";

const DEFAULTS = {
  theme: "system", // or light, dark
  areas: {}, // panel id: area; missing: the panel's own
  hidden: [], // ids of panels
  open: {}, // area: id of the panel that is shown
  layers: {
    particles: true,
    belief: true,
    cone: true,
    mirrored: true,
    truth: true,
    percepts: true,
    path: true,
    ring: false,
  },
  annotations: true,
  wall: "strip", // or ring
  span: 60, // s, of the timeline
  machines: ["orientation", "background_training"], // bands of the timeline
  scenario: true, // the states of the scenario are bands of the timeline, too
  pinned: [
    "clock.time",
    "pose.x",
    "pose.y",
    "pose.rotation",
    "confidence.evidence",
    "confidence.status",
    "robot.posture",
  ],
  levels: [1, 2, 3, 4, 5], // of the log
};

function load() {
  let stored = {};
  try {
    const value = JSON.parse(localStorage.getItem(KEY));
    if (value !== null && typeof value === "object") stored = value;
  } catch {
    // no storage, or a damaged entry: the defaults
  }
  const settings = structuredClone(DEFAULTS);
  for (const [name, value] of Object.entries(stored)) {
    const standard = DEFAULTS[name];
    if (standard === undefined || typeof value !== typeof standard || Array.isArray(value) !== Array.isArray(standard))
      continue;
    settings[name] = typeof standard === "object" && !Array.isArray(standard) ? { ...standard, ...value } : value;
  }
  settings.span = Math.min(600, Math.max(3, settings.span || DEFAULTS.span));
  for (const list of ["machines", "pinned", "hidden"])
    settings[list] = settings[list].filter((it) => typeof it === "string");
  return settings;
}

export const settings = load();

/// Changes settings and stores them.
export function set(change) {
  Object.assign(settings, change);
  try {
    localStorage.setItem(KEY, JSON.stringify(settings));
  } catch {
    // The page works without storage.
  }
  changedByUser();
}

export function reset() {
  set(structuredClone(DEFAULTS));
}
