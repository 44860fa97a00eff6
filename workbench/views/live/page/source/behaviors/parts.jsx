// SPDX-License-Identifier: MIT
// Parts that the list of behaviors and a chosen behavior share.
import { fixed } from "../format.js";
import { canCall, store } from "../robot.js";
import { openAt } from "../scripts/open_at.js";
import { faultOf, pathText } from "./view.js";

export const nameText = (name) => name.replaceAll("_", " ");
export const stateText = (machine) => (machine.stopped ? "stopped after an error" : pathText(machine.state));

/// The sign of a machine that is not part of the robot.
export const ScenarioMark = () => (
  <span class="badge" title="The operator's script, which runs beside the robot. The robot knows nothing of it.">
    scenario
  </span>
);

/// The parts of the body that the machine requests; struck through if another machine has it.
export function Parts({ parts = [] }) {
  if (!parts.length) return null;
  return (
    <span class="parts">
      {parts.map(({ part, outranked_by: rival }) => (
        <span
          key={part}
          class={rival ? "badge part lost" : "badge part"}
          title={rival ? `${nameText(rival)} has the ${part}` : `Has the ${part}`}
        >
          {part}
        </span>
      ))}
    </span>
  );
}

/// A place in a script. It opens the script there if the robot shows its scripts.
export function Place({ file, line, children }) {
  if (!file || !canCall("script")) return <span class="soft place">{children}</span>;
  return (
    <button class="link place" title={`Open ${file} at line ${line}`} onClick={() => openAt(file, line)}>
      {children}
    </button>
  );
}

/// cost: of meanCosts(); undefined: not known.
export function Cost({ cost }) {
  if (!cost) return null;
  const { microseconds, share, memory } = cost;
  return (
    <span class="cost value" title="Time of the script in a frame, as a share of the frame, and its memory">
      {fixed(microseconds, 0)} µs · {fixed(100 * share, 1)} % · {fixed(memory / 1024, 0)} KiB
    </span>
  );
}

export function Fault({ machine, until }) {
  if (!machine.errors && !machine.stopped) return null;
  const fault = faultOf(store.log, machine.name, until);
  if (!fault) return <div class="fault">{machine.errors} errors; the log has the details if they are recent.</div>;
  const { file, line, name, message } = fault;
  const where = file ? `${file}:${line}` : name;
  return (
    <div class="fault">
      <Place file={file} line={line}>
        <b>{where}</b>
      </Place>{" "}
      {message.replace(`${where}: `, "")}
    </div>
  );
}
