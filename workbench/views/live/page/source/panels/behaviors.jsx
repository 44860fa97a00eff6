// SPDX-License-Identifier: MIT
// The behaviors: state, time in it, last transitions with their reasons, commands, and faults with file and line.
import { useState } from "preact/hooks";

import { duration, seconds } from "../format.js";
import { store } from "../robot.js";
import { set, settings } from "../settings.js";
import { useChanges } from "../ticker.js";

const SHOWN = 8; // transitions of an opened machine
const ERROR = 4; // level of the log

const path = (state) => state.split("/").join(" › ");

/// The last events of a machine before an instant, newest first.
function eventsOf(machine, until, count) {
  const found = [];
  for (let i = store.events.length - 1; i >= 0 && found.length < count; --i) {
    const event = store.events[i];
    if (event.time <= until + 1e-6 && event.machine === machine && event.kind !== "note") found.push(event);
  }
  return found;
}

/// The last fault of a machine before an instant: a line of the log with its file.
function faultOf(machine, until) {
  for (let i = store.log.length - 1; i >= 0; --i) {
    const line = store.log[i];
    if (
      line.time <= until + 1e-6 &&
      line.level >= ERROR &&
      [line.name, line.file].some((text) => text?.includes(`${machine}.lua`) || text === machine)
    )
      return line;
  }
  return null;
}

const placeOf = ({ file, line, name }) => (file ? `${file}:${line}` : name);

export function EventText({ event }) {
  if (event.kind === "command")
    return (
      <span>
        <b class={event.granted ? "good" : "bad"}>
          {event.command} {event.verdict}
        </b>{" "}
        ({event.reason})
      </span>
    );
  return (
    <span>
      {path(event.to)} <span class="soft">({event.reason})</span>
    </span>
  );
}

function Machine({ machine, until, isOpen, onToggle }) {
  const events = eventsOf(machine.name, until, isOpen ? SHOWN : 1);
  const fault = machine.errors > 0 || machine.stopped ? faultOf(machine.name, until) : null;
  const isBand = settings.machines.includes(machine.name);
  const chooseBand = () =>
    set({
      machines: isBand
        ? settings.machines.filter((name) => name !== machine.name)
        : [...settings.machines, machine.name],
    });
  return (
    <li class={machine.stopped ? "machine stopped" : "machine"}>
      <div class="row">
        <button class="plain name" aria-expanded={isOpen} onClick={onToggle}>
          {machine.name.replaceAll("_", " ")}
        </button>
        <span class="state">{machine.stopped ? "stopped after an error" : path(machine.state)}</span>
        <span class="value">{duration(machine.seconds)}</span>
      </div>
      {!isOpen && events[0] && events[0].reason && <div class="reason">{events[0].reason}</div>}
      {isOpen && (
        <ol class="events">
          {events.map((event) => (
            <li key={`${event.time}${event.to ?? event.command}`}>
              <button class="plain time" title="Show this instant" onClick={() => store.show(event.time)}>
                {seconds(event.time)}
              </button>
              <EventText event={event} />
            </li>
          ))}
          {!events.length && <li class="soft">No transition in the stored time.</li>}
          <li>
            <button
              class="chip small"
              aria-pressed={isBand}
              title="Show the states of this behavior in the timeline"
              onClick={chooseBand}
            >
              show in the timeline
            </button>
          </li>
        </ol>
      )}
      {fault && (
        <div class="fault">
          <b>{placeOf(fault)}</b> {fault.message.replace(`${placeOf(fault)}: `, "")}
        </div>
      )}
      {!fault && machine.errors > 0 && (
        <div class="fault">{machine.errors} errors; the log has the details if they are recent.</div>
      )}
    </li>
  );
}

function Behaviors() {
  useChanges(150);
  const [open, setOpen] = useState(new Set());
  const found = store.read("/machines");
  if (!found) return <p class="empty">No behavior has reported its state yet.</p>;
  const { machines, published } = found.value;
  const until = store.shown().time;
  const toggle = (name) => {
    const next = new Set(open);
    if (!next.delete(name)) next.add(name);
    setOpen(next);
  };
  return (
    <div class="scroll">
      <ul class="machines" aria-label="Running now">
        {machines.map((machine) => (
          <Machine
            key={machine.name}
            machine={machine}
            until={until}
            isOpen={open.has(machine.name)}
            onToggle={() => toggle(machine.name)}
          />
        ))}
      </ul>
      {published.length > 0 && <p class="soft pad">Published: {published.join(", ")}</p>}
    </div>
  );
}

export default { id: "behaviors", title: "Behaviors", area: "right", key: "4", Component: Behaviors };
