// SPDX-License-Identifier: MIT
// All panels, in the order of their tabs. A panel is one file that exports {id, title, area, key, Component}: `area` is
// where it is placed first, `key` opens it from the keyboard.
import behaviors from "./behaviors.jsx";
import cameras from "./cameras.jsx";
import field from "./field.jsx";
import log from "./log.jsx";
import notes from "./notes.jsx";
import operator from "./operator.jsx";
import parameters from "./parameters.jsx";
import scripts from "./scripts.jsx";
import timeline from "./timeline.jsx";
import wall from "./wall.jsx";
import whatIf from "./what_if.jsx";
import world from "./world.jsx";

export const panels = [
  field,
  wall,
  cameras,
  behaviors,
  parameters,
  world,
  log,
  notes,
  operator,
  timeline,
  scripts,
  whatIf,
];
