// SPDX-License-Identifier: MIT
// One behavior: its states as a graph, its open transitions, and its last events.
import { duration, seconds } from "../format.js";
import { canCall, isReplay, store, whyGone } from "../robot.js";
import { set, settings } from "../settings.js";
import { choice, choose, toggleGraph, useFocus } from "./choice.js";
import { definitionAt } from "./definitions.js";
import { StateGraph } from "./graph.jsx";
import { Cost, Fault, Parts, Place, ScenarioMark, nameText, stateText } from "./parts.jsx";
import { Transitions } from "./transitions.jsx";
import { declaredTransitions, eventsOf, isWithin, openTransitions, pathText, transitionOf } from "./view.js";

const SHOWN = 8; // events
const SEARCHED = 20; // events, for the last transition

function EventText({ event }) {
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
      {pathText(event.to)} <span class="soft">({event.reason})</span>
    </span>
  );
}

function Events({ name, until }) {
  const events = eventsOf(store.events, name, until, SHOWN);
  return (
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
    </ol>
  );
}

function BandChoice({ machine: { name, scenario } }) {
  const isBand = scenario ? settings.scenario : settings.machines.includes(name);
  const others = settings.machines.filter((it) => it !== name);
  const toggle = () => set(scenario ? { scenario: !isBand } : { machines: isBand ? others : [...others, name] });
  return (
    <button
      class="chip small"
      aria-pressed={isBand}
      title="Show these states in the timeline"
      onClick={toggle}
    >
      show in the timeline
    </button>
  );
}

function Head({ machine }) {
  const title = useFocus("title");
  return (
    <div class="row tight chosen-head">
      <button
        class="button"
        title="Show all behaviors (Esc)"
        aria-label="Show all behaviors"
        onClick={() => choose(null)}
      >
        ‹
      </button>
      <h2 class="chosen-name" ref={title} tabIndex={-1}>
        {nameText(machine.name)}
      </h2>
      {machine.scenario && <ScenarioMark />}
      <span class="state" title={stateText(machine)}>
        {stateText(machine)}
      </span>
      <Parts parts={machine.parts} />
      <span class="value">{duration(machine.seconds)}</span>
      <button
        class="chip small"
        aria-pressed={choice.isGraphShown}
        title="Show the graph of the states"
        onClick={toggleGraph}
      >
        graph
      </button>
    </div>
  );
}

/// The state whose transitions are listed, and these: {path, rows, isActive}. `open`: from the active states. The robot
/// does not send the open transitions of a scenario, so these are the declared ones.
function listedOf(machine, definition, open) {
  if (machine.scenario && definition) {
    const active = definition.states.findIndex(({ path }) => path === machine.state);
    const shown = choice.state ?? active;
    const { path = machine.state } = definition.states[shown] ?? {};
    return { path, rows: declaredTransitions(definition, shown), isActive: path === machine.state };
  }
  const state = definition?.states[choice.state];
  if (!state || state.path === machine.state) return { path: machine.state, rows: open, isActive: true };
  const { path } = state;
  if (isWithin(machine.state, path))
    return { path, rows: open.filter((row) => isWithin(path, row.from)), isActive: false };
  return { path, rows: declaredTransitions(definition, choice.state), isActive: false };
}

/// A replay does not run the scenario.
const isReplayed = (machine) => machine.scenario && isReplay();

function Graph({ machine, definition, problem, listed, until }) {
  if (!definition) {
    const isOffered = canCall("machine") && !isReplayed(machine);
    const missing = isReplayed(machine)
      ? "A recording has the states of its scenario, but not their graph."
      : "This robot does not send the states.";
    const offered = isOffered ? problem || "Waiting for the states…" : missing;
    return <p class="soft pad">{whyGone() || offered}</p>;
  }
  const last = eventsOf(store.events, machine.name, until, SEARCHED).find((it) => it.kind === "transition");
  const chooseState = (state) => {
    const isShown = state === choice.state || definition.states[state].path === machine.state;
    choose(machine.name, isShown ? null : state);
  };
  return (
    <StateGraph
      definition={definition}
      active={machine.state}
      chosen={listed.isActive ? null : choice.state}
      numbers={new Map(listed.rows.map((row, i) => [row.index, i + 1]))}
      last={transitionOf(definition, last)}
      onChoose={chooseState}
    />
  );
}

/// machine: of /machines; cost: of meanCosts(); until: the shown instant.
export function Chosen({ machine, cost, until }) {
  const { definition, problem } = isReplayed(machine)
    ? { definition: null, problem: "" }
    : definitionAt(machine.name, until);
  const found = store.read("/conditions");
  const open = openTransitions(found?.value.conditions ?? [], machine.name, definition);
  const listed = listedOf(machine, definition, open);
  const { path, rows, isActive } = listed;
  const onKeyDown = (event) => {
    if (event.key !== "Escape") return;
    event.stopPropagation();
    choose(choice.state === null ? null : machine.name);
  };
  return (
    <div class="fill column" onKeyDown={onKeyDown}>
      <Head machine={machine} />
      <div class={choice.isGraphShown ? "chosen-machine with-graph" : "chosen-machine"}>
        {choice.isGraphShown && (
          <div class="chosen-graph">
            <Graph machine={machine} definition={definition} problem={problem} listed={listed} until={until} />
          </div>
        )}
        <div class="chosen-lists">
          <Fault machine={machine} until={until} />
          <div class="row tight heading">
            <h3 class="grow">
              Transitions from {pathText(path) || "any state"}
              {!isWithin(machine.state, path) && <span class="soft"> (not active)</span>}
            </h3>
            {!isActive && (
              <button class="link" onClick={() => choose(machine.name)}>
                show the active state
              </button>
            )}
          </div>
          {(machine.scenario ? definition : found || !isActive) ? (
            <Transitions machine={machine.name} rows={rows} world={store.read("/world")?.value} />
          ) : (
            <p class="soft pad">The open transitions of this instant are not known.</p>
          )}
          <div class="row tight heading">
            <h3 class="grow">Last events</h3>
            <BandChoice machine={machine} />
          </div>
          <Events name={machine.name} until={until} />
          <div class="row tight heading">
            <span class="grow">
              {definition && (
                <Place file={definition.file} line={definition.line}>
                  {definition.file}
                </Place>
              )}
            </span>
            <Cost cost={cost} />
          </div>
        </div>
      </div>
    </div>
  );
}
