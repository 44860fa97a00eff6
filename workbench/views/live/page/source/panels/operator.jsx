// SPDX-License-Identifier: MIT
// The operator beside the field: lift, place, push, penalize the robot, and change the light.
import { useState } from "preact/hooks";

import { fixed } from "../format.js";
import {
  act,
  canOperate,
  mirrorRobot,
  place,
  placedPose,
  run,
  setInitialPose,
  whyNoOperator,
} from "../operator.js";
import { canCall, isReplay, store } from "../robot.js";
import { useChanges } from "../ticker.js";

const DEGREE = Math.PI / 180;

const FIELDS = [
  ["x", "x in m"],
  ["y", "y in m"],
  ["degrees", "degrees"],
];

function Action({ title, pressed, children, onAct }) {
  return (
    <button class="button" title={title} aria-pressed={pressed} onClick={onAct}>
      {children}
    </button>
  );
}

function asTexts({ x, y, rotation }) {
  return { x: x.toFixed(2), y: y.toFixed(2), degrees: (rotation / DEGREE).toFixed(0) };
}

/// A pose as three numbers, for "Put down" and the initial pose.
function Place() {
  const [texts, setTexts] = useState({ x: "0", y: "0", degrees: "0" });
  const numbers = Object.fromEntries(
    Object.entries(texts).map(([name, text]) => [name, text.trim() ? Number(text.replace(",", ".")) : NaN]),
  );
  const isValid = Object.values(numbers).every(Number.isFinite);
  const pose = { x: numbers.x, y: numbers.y, rotation: numbers.degrees * DEGREE };
  const truth = store.shown()?.truth;
  return (
    <form
      class="pad"
      onSubmit={(event) => {
        event.preventDefault();
        if (isValid) (canOperate() ? place : setInitialPose)(pose);
      }}
    >
      <div class="row">
        {FIELDS.map(([name, label]) => (
          <label key={name} class="grow coordinate">
            <span class="soft">{label}</span>
            <input
              type="text"
              inputmode="decimal"
              value={texts[name]}
              aria-invalid={!Number.isFinite(numbers[name])}
              onInput={(event) => setTexts({ ...texts, [name]: event.currentTarget.value })}
            />
          </label>
        ))}
      </div>
      <div class="chips actions">
        {canOperate() && (
          <button class="button" disabled={!isValid}>
            Put down
          </button>
        )}
        <button
          class="button"
          type={canOperate() ? "button" : "submit"}
          disabled={!isValid}
          title="Give the robot this pose as its belief"
          onClick={canOperate() ? () => setInitialPose(pose) : undefined}
        >
          Set initial pose
        </button>
        {truth && (
          <button class="link" type="button" onClick={() => setTexts(asTexts(placedPose() ?? store.shown()?.truth ?? truth))}>
            use the true pose
          </button>
        )}
      </div>
    </form>
  );
}

function Light() {
  const [stops, setStops] = useState(0);
  return (
    <div class="pad">
      <label class="row">
        <span>Exposure</span>
        <input
          type="range"
          class="grow"
          min="-4"
          max="4"
          step="0.25"
          value={stops}
          aria-label="Exposure in stops"
          onInput={(event) => setStops(Number(event.currentTarget.value))}
          onChange={(event) => act("set_exposure_compensation", { stops: Number(event.currentTarget.value) })}
        />
        <span class="value">{fixed(stops, 2)} stops</span>
      </label>
    </div>
  );
}

function Operator() {
  useChanges(250);
  const robot = store.read("/world")?.value.robot ?? {};
  const why = whyNoOperator();
  return (
    <div class="fill scroll">
      {why ? (
        <p class="empty">{why}</p>
      ) : (
        <>
          <div class="chips actions" role="group" aria-label="Actions of the operator">
            <Action onAct={mirrorRobot} title="Carry the robot to the mirrored pose of its true pose">
              Mirror
            </Action>
            <Action onAct={() => act("pick_up")} title="Lift the robot">
              Pick up
            </Action>
            <Action onAct={() => act("push_over")} title="Make the robot fall">
              Push over
            </Action>
            <Action
              onAct={() => act("penalize", { penalized: !robot.penalized })}
              pressed={robot.penalized === true}
            >
              {robot.penalized ? "End the penalty" : "Penalize"}
            </Action>
            <Action
              onAct={() => act("change_light")}
              title="Change the light of the hall, the objects and the people"
            >
              Change light
            </Action>
          </div>
          <Light />
        </>
      )}
      {canCall("operator", true) && !isReplay() && <Place />}
      {run.problem && (
        <div class="fault pad" role="alert">
          {run.problem}
        </div>
      )}
      {!why && (
        <p class="empty">In the panel Field, drag the true robot (amber) to carry it. Poses are in the team's axes.</p>
      )}
    </div>
  );
}

export default { id: "operator", title: "Operator", area: "middle", key: "o", Component: Operator };
