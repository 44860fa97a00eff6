// SPDX-License-Identifier: MIT
// The behaviors that run now, and the scenario: state, time in it, the parts of the body that they request, the reason
// of the last change, cost, and faults with file and line. A click on a name shows one of them.
import "../behaviors/behaviors.css";
import { choice, choose, useFocus } from "../behaviors/choice.js";
import { Chosen } from "../behaviors/chosen.jsx";
import { Cost, Fault, Parts, ScenarioMark, nameText, stateText } from "../behaviors/parts.jsx";
import { eventsOf, meanCosts } from "../behaviors/view.js";
import { duration, fixed } from "../format.js";
import { store } from "../robot.js";
import { useChanges } from "../ticker.js";

const COST_FRAMES = 10; // over which costs are averaged

function costsNow() {
  const messages = [];
  for (let i = store.shownIndex(); i >= 0 && messages.length < COST_FRAMES; --i) {
    const part = store.frames[i].parts["/costs"];
    if (part) messages.push(store.parse(part));
    else if (messages.length) break;
  }
  return meanCosts(messages);
}

function Machine({ machine, cost, until }) {
  const button = useFocus(machine.name);
  const [last] = eventsOf(store.events, machine.name, until, 1);
  return (
    <li class={machine.stopped ? "machine stopped" : "machine"}>
      <div class="row">
        <button class="plain name" ref={button} onClick={() => choose(machine.name)}>
          {nameText(machine.name)}
        </button>
        {machine.scenario && <ScenarioMark />}
        <span class="state" title={stateText(machine)}>
          {stateText(machine)}
        </span>
        <Parts parts={machine.parts} />
        <span class="value">{duration(machine.seconds)}</span>
      </div>
      <div class="row">
        <span class="reason grow">{last?.reason || "\u00a0"}</span>
        <Cost cost={cost} />
      </div>
      <Fault machine={machine} until={until} />
    </li>
  );
}

function Summary({ machines, costs }) {
  const count = machines.filter(({ scenario }) => !scenario).length;
  const sum = machines.reduce((all, { name }) => all + (costs.get(name)?.share ?? 0), 0);
  return (
    <p class="soft summary value">
      {count} {count === 1 ? "behavior" : "behaviors"}
      {costs.size > 0 && `, together ${fixed(100 * sum, 1)} % of a frame`}
      {count < machines.length && ", and the scenario"}
    </p>
  );
}

function Behaviors() {
  useChanges(150);
  const found = store.read("/machines");
  if (!found) return <p class="empty">No behavior has reported its state yet.</p>;
  const { machines, published } = found.value;
  const until = store.shown().time;
  const costs = costsNow();
  const chosen = machines.find(({ name }) => name === choice.machine);
  if (chosen) return <Chosen machine={chosen} cost={costs.get(chosen.name)} until={until} />;
  return (
    <div class="scroll">
      <Summary machines={machines} costs={costs} />
      <ul class="machines" aria-label="Running now">
        {machines.map((machine) => (
          <Machine key={machine.name} machine={machine} cost={costs.get(machine.name)} until={until} />
        ))}
      </ul>
      {published.length > 0 && <p class="soft pad">Published: {published.join(", ")}</p>}
    </div>
  );
}

export default { id: "behaviors", title: "Behaviors", area: "right", key: "4", Component: Behaviors };
