// SPDX-License-Identifier: MIT
// The log with levels, the time of the robot, and search.
import { useState } from "preact/hooks";

import { fixed } from "../format.js";
import { store } from "../robot.js";
import { SearchBox } from "../search_box.jsx";
import { set, settings } from "../settings.js";
import { useChanges } from "../ticker.js";

const LEVELS = [
  [1, "debug"],
  [2, "info"],
  [3, "warning"],
  [4, "error"],
  [5, "fatal"],
];
const SHOWN = 300;

function Log() {
  useChanges(250);
  const [search, setSearch] = useState("");
  const until = store.shown()?.time ?? 0;
  const text = search.toLowerCase();
  const lines = [];
  for (let i = store.log.length - 1; i >= 0 && lines.length < SHOWN; --i) {
    const line = store.log[i];
    if (!store.isLive && line.time > until + 1e-6) continue;
    if (!settings.levels.includes(Math.max(1, line.level))) continue;
    if (text && !`${line.name} ${line.message} ${line.file}`.toLowerCase().includes(text)) continue;
    lines.push(line);
  }
  const toggle = (level) =>
    set({
      levels: settings.levels.includes(level)
        ? settings.levels.filter((it) => it !== level)
        : [...settings.levels, level],
    });
  return (
    <div class="fill column">
      <div class="row pad">
        <SearchBox placeholder="Search the log" value={search} onSearch={setSearch} />
      </div>
      <div class="chips" role="group" aria-label="Levels">
        {LEVELS.map(([level, name]) => (
          <button key={level} class="chip" aria-pressed={settings.levels.includes(level)} onClick={() => toggle(level)}>
            {name}
          </button>
        ))}
      </div>
      <ol class="scroll log">
        {lines.map((line, i) => (
          <li key={`${line.time} ${lines.length - i}`} class={`level${line.level}`}>
            <button class="plain time" title="Show this instant" onClick={() => store.show(line.time)}>
              {fixed(line.time, 2)}
            </button>
            <span>
              <b>{line.name}</b> {line.message}
              {line.file && (
                <code>
                  {" "}
                  {line.file}:{line.line}
                </code>
              )}
            </span>
          </li>
        ))}
        {!lines.length && (
          <li class="empty">
            {store.log.length ? "No line matches." : "The robot has not logged anything since this page was opened."}
          </li>
        )}
      </ol>
    </div>
  );
}

export default { id: "log", title: "Log", area: "right", key: "7", Component: Log };
