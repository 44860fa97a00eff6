// SPDX-License-Identifier: MIT
// The definitions of machines, as the robot runs them: asked for once, and again after a reload. Instants before a
// reload are shown with the definition of then, if this page had it.
import { call, canCall, store } from "../robot.js";
import { isAccepted } from "../scripts/reload_result.js";
import { changed } from "../ticker.js";
import { openTransitions } from "./view.js";

const SERVICE = "machine";
const RETRY = 2000; // ms
const MOST_VERSIONS = 20; // of a machine

let run = null; // that of the store, to which the definitions belong
const machines = new Map(); // name: {versions: [{since, definition}], asked, problem, isAsking, until}

function entryOf(name) {
  if (run !== store.run) machines.clear();
  run = store.run;
  if (!machines.has(name))
    machines.set(name, { versions: [], asked: -Infinity, problem: "", isAsking: false, until: -Infinity });
  return machines.get(name);
}

/// The time of the last reload in the log after an instant; -Infinity: none.
function lastReload(since) {
  for (let i = store.log.length - 1; i >= 0 && store.log[i].time > since; --i)
    if (isAccepted(store.log[i])) return store.log[i].time;
  return -Infinity;
}

async function ask(name, entry, since) {
  entry.isAsking = true;
  entry.asked = Date.now();
  try {
    const { time, machine } = await call(SERVICE, { machine: name });
    const last = entry.versions.at(-1);
    // The same object for the same definition, so that nothing is laid out again.
    if (!last || JSON.stringify(last.definition) !== JSON.stringify(machine))
      entry.versions.push({ since: last ? since : -Infinity, definition: machine });
    if (entry.versions.length > MOST_VERSIONS) entry.versions.shift();
    // Without frames there is no time.
    entry.until = Math.max(entry.until, time || store.newest);
    entry.problem = "";
  } catch (error) {
    entry.problem = error.message;
  }
  entry.isAsking = false;
  changed();
}

/// Whether the newest open transitions are those of another definition.
function isOutdated(name, definition) {
  const found = store.frames.at(-1)?.parts["/conditions"];
  if (!found) return false;
  return openTransitions(store.parse(found).conditions, name, definition).some((it) => it.index < 0);
}

/// {definition, problem}: that of a machine at an instant. definition: null while it is not known.
export function definitionAt(name, time) {
  const entry = entryOf(name);
  if (canCall(SERVICE) && !entry.isAsking) {
    const reload = lastReload(entry.until);
    const isFirst = !entry.versions.length;
    const isLate = Date.now() - entry.asked > RETRY;
    if (reload > entry.until && !isFirst && !entry.problem) ask(name, entry, reload);
    else if (isLate && (isFirst || entry.problem || isOutdated(name, entry.versions.at(-1).definition)))
      ask(name, entry, store.newest);
  }
  const version = entry.versions.findLast((it) => it.since <= time) ?? entry.versions[0];
  return { definition: version?.definition ?? null, problem: entry.problem };
}
