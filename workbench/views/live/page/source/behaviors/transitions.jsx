// SPDX-License-Identifier: MIT
// The transitions that may be taken: their conditions, how long these have held, and the values that they read.
import { entered, fixed, plain } from "../format.js";
import { parameters } from "../robot.js";
import { Place } from "./parts.jsx";
import { fieldOf, pathText } from "./view.js";

const RESULTS = {
  none: ["timed", "no condition, only a time"],
  "not evaluated": ["not evaluated", "not evaluated since the state was entered"],
  no: ["no", "the condition does not hold"],
  yes: ["yes", "the condition holds"],
  failed: ["failed", "the script failed in the condition"],
};

/// Seconds of a dwell time as a bar. needed: undefined while the script has not given it.
function Dwell({ label, soFar, needed }) {
  const share = needed > 0 ? Math.min(1, soFar / needed) : 0;
  const digits = needed < 10 ? 2 : 1;
  const shown = fixed(Math.min(soFar, needed ?? soFar), digits);
  const text = needed === undefined ? `${shown} s` : `${shown} of ${fixed(needed, digits)} s`;
  return (
    <div class="dwell">
      <span class="label">{label}</span>
      <div
        class={share >= 1 ? "track full" : "track"}
        role="progressbar"
        aria-label={label}
        aria-valuemin={0}
        aria-valuemax={100}
        aria-valuenow={Math.round(100 * share)}
        aria-valuetext={text}
      >
        <i style={{ width: `${100 * share}%` }} />
      </div>
      <span class="value">{text}</span>
    </div>
  );
}

/// A dwell time as it is declared: "0.5 s", or the name of a parameter with its value.
function declaredText(machine, text) {
  const parameter = parameters.all.get(`${machine}.${text}`);
  return parameter ? `${text} (${`${entered(parameter.value)} ${parameter.unit ?? ""}`.trim()})` : text;
}

function Row({ machine, number, row, world }) {
  const [result, meaning] = RESULTS[row.when] ?? [];
  return (
    <li class="transition">
      <div class="row">
        <span class="badge-number" aria-hidden="true">
          {number}
        </span>
        <b class="target">→ {pathText(row.target)}</b>
        {result && (
          <span class={`result ${row.when.replace(" ", "-")}`} title={meaning}>
            {result}
          </span>
        )}
        <span class="grow" />
        <Place file={row.file} line={row.line}>
          line {row.line}
        </Place>
      </div>
      <div class="because">
        {row.reason}
        {row.from === "" && <span class="soft"> (from any state)</span>}
      </div>
      {row.held !== undefined && <Dwell label="holds for" soFar={row.held} needed={row.lasting} />}
      {row.waited !== undefined && <Dwell label="in the state for" soFar={row.waited} needed={row.after} />}
      {row.lastingText && <div class="soft">must hold for {declaredText(machine, row.lastingText)}</div>}
      {row.afterText && <div class="soft">after {declaredText(machine, row.afterText)} in the state</div>}
      {row.reads.length > 0 && (
        <dl class="reads">
          {row.reads.map((name) => (
            <div key={name}>
              <dt>
                <code>{name}</code>
              </dt>
              <dd class="value">{plain(fieldOf(world, name))}</dd>
            </div>
          ))}
        </dl>
      )}
    </li>
  );
}

/// rows: as openTransitions() or declaredTransitions() return them; world: of the shown frame.
export function Transitions({ machine, rows, world }) {
  if (!rows.length) return <p class="soft pad">No transition leaves this state.</p>;
  return (
    <ol class="transitions" aria-label="Transitions">
      {rows.map((row, i) => (
        <Row key={`${row.index} ${row.line} ${row.target} ${i}`} machine={machine} number={i + 1} row={row} world={world} />
      ))}
    </ol>
  );
}
