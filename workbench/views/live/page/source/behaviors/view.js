// SPDX-License-Identifier: MIT
// What the panel shows of a machine, joined from its definition and from the messages of a frame. Pure functions.

const TIME_TOLERANCE = 1e-6; // s
const ERROR = 4; // level of the log

export const pathText = (path) => path.split("/").join(" › ");

/// Whether a path is the other one, or inside it; "" is the machine itself.
export const isWithin = (path, outer) => outer === "" || path === outer || path.startsWith(`${outer}/`);

/// The last events of a machine before an instant, newest first.
export function eventsOf(events, machine, until, count) {
  const found = [];
  for (let i = events.length - 1; i >= 0 && found.length < count; --i) {
    const event = events[i];
    if (event.time <= until + TIME_TOLERANCE && event.machine === machine && event.kind !== "note") found.push(event);
  }
  return found;
}

/// The last fault of a machine before an instant: a line of the log with its file, or null.
export function faultOf(log, machine, until) {
  for (let i = log.length - 1; i >= 0; --i) {
    const line = log[i];
    if (
      line.time <= until + TIME_TOLERANCE &&
      line.level >= ERROR &&
      [line.name, line.file].some((text) => text?.includes(`${machine}.lua`) || text === machine)
    )
      return line;
  }
  return null;
}

/// The transition of a definition that an event reports, as its index; -1: none.
export function transitionOf(definition, event) {
  if (!event || event.kind !== "transition") return -1;
  const { states, transitions } = definition;
  return transitions.findIndex(
    ({ from, to, reason }) =>
      reason === event.reason && isWithin(event.from, states[from].path) && isWithin(event.to, states[to].path),
  );
}

/// The open transitions of a machine in a frame, in the order in which they are checked: {index, from, target, reason,
/// file, line, reads, when, held, lasting, waited, after}. `index`: in the definition; -1: the definition does not
/// have it, so it is not the one that runs. `definition` may be null.
export function openTransitions(conditions, machine, definition) {
  const used = new Set();
  return conditions
    .filter((condition) => condition.machine === machine)
    .map((condition) => {
      const index =
        definition?.transitions.findIndex(
          ({ from, to, line, reason }, i) =>
            !used.has(i) &&
            line === condition.line &&
            reason === condition.reason &&
            definition.states[from].path === condition.from &&
            definition.states[to].path === condition.target,
        ) ?? -1;
      used.add(index);
      const { file = "", reads = [] } = definition?.transitions[index] ?? {};
      return { ...condition, index, file, reads };
    });
}

/// The transitions from a state and from those around it, in the same form, without results.
export function declaredTransitions(definition, state) {
  const around = [];
  for (let at = state; at >= 0; at = definition.states[at].outer) around.unshift(at);
  return around.flatMap((from) =>
    definition.transitions.flatMap((transition, index) =>
      transition.from === from
        ? [
            {
              ...transition,
              index,
              from: definition.states[from].path,
              target: definition.states[transition.to].path,
              when: "",
              lastingText: transition.lasting,
              afterText: transition.after,
              lasting: undefined,
              after: undefined,
            },
          ]
        : [],
    ),
  );
}

/// Mean cost of each machine over some messages of /costs: Map(name: {microseconds, share, memory}). `share`: of the
/// duration of a frame.
export function meanCosts(messages) {
  const costs = new Map();
  for (const { machines, frame_milliseconds: whole } of messages) {
    for (const { name, microseconds, memory } of machines) {
      const sum = costs.get(name) ?? { microseconds: 0, milliseconds: 0, memory };
      sum.microseconds += microseconds / messages.length;
      sum.milliseconds += whole / messages.length;
      costs.set(name, sum);
    }
  }
  for (const cost of costs.values()) cost.share = cost.milliseconds > 0 ? cost.microseconds / 1e3 / cost.milliseconds : 0;
  return costs;
}

/// The value of a world field or of an application, such as "pose.x" and "input.ball.position.x".
export function fieldOf(world, name) {
  return name.split(".").reduce((value, part) => value?.[part], world);
}
