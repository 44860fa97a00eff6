// SPDX-License-Identifier: MIT
// What if: the last seconds of the run with changes that the robot does not have, next to what happened.
import { Canvas } from "../draw/canvas.jsx";
import { drawTrial, trialBandsHeight } from "../draw/trial.js";
import { entered, seconds } from "../format.js";
import { canSetParameters, limits, parameters, store } from "../robot.js";
import { theme } from "../theme.js";
import { useChanges } from "../ticker.js";
import {
  applyParameters,
  askAgain,
  canTry,
  dropAll,
  dropParameter,
  dropScript,
  isTrying,
  setSeconds,
  switchTrial,
  trial,
  whyNoTrial,
} from "../trial.js";

const SPANS = [10, 30, 60];
const PLOT = 110; // pixels, the least height of the evidence

function Tried() {
  return (
    <div class="chips">
      {[...trial.parameters].map(([name, value]) => (
        <span key={name} class="badge">
          <code>{name}</code> {entered(parameters.all.get(name)?.value ?? "–")} → <b>{entered(value)}</b>{" "}
          <button class="link" aria-label={`Drop ${name}`} title="Drop this change" onClick={() => dropParameter(name)}>
            ✕
          </button>
        </span>
      ))}
      {[...trial.scripts.keys()].map((file) => (
        <span key={file} class="badge">
          <code>{file}</code> as edited{" "}
          <button class="link" aria-label={`Drop ${file}`} title="Drop this change" onClick={() => dropScript(file)}>
            ✕
          </button>
        </span>
      ))}
      {trial.parameters.size > 0 && (
        <button class="button" disabled={!canSetParameters()} onClick={applyParameters} title="Set these values on the robot">
          Apply to the robot
        </button>
      )}
      <button class="button" onClick={dropAll}>
        Drop all
      </button>
    </div>
  );
}

function Verdict({ answer }) {
  const { first_decision: decision, first_action: action, guess_from: guess } = answer;
  return (
    <div class="pad verdict">
      <div>
        {decision ? (
          <>
            <b>The first decision that differs</b> is at {seconds(decision.time)}:{" "}
            {decision.recorded ? "only the robot did this" : "only the what-if does this"}:{" "}
            <b>{decision.text}</b>
          </>
        ) : (
          <>
            <b>No decision differs.</b> To try one before {seconds(answer.from)}, click it in the timeline, and press
            “Again”.
          </>
        )}
      </div>
      <div class="soft">
        {action
          ? `From ${seconds(guess)} on it is a guess, because the robot would have acted differently and seen something else (${action.what}: ${action.recorded}, in the what-if: ${action.tried}).`
          : "The robot would have acted the same in each frame, so all of it is exact."}{" "}
        {answer.gap && "Some frames in between are missing. "}
        {answer.frames} frames from {seconds(answer.from)} to {seconds(answer.to)}, replayed in{" "}
        {seconds(answer.seconds, 1)}.
      </div>
    </div>
  );
}

function Events({ answer }) {
  const differing = answer.events.filter((event) => event.recorded !== event.tried);
  if (!differing.length) return null;
  return (
    <ul class="differences" aria-label="Decisions that differ">
      {differing.slice(0, 200).map((event, i) => (
        <li key={i}>
          <button class="plain" onClick={() => store.show(event.time)} title="Show this instant in every panel">
            <span class="value">{seconds(event.time)}</span>{" "}
            <span class={event.recorded ? "badge happened" : "badge"}>{event.recorded ? "happened" : "what if"}</span>{" "}
            {event.text}
          </button>
        </li>
      ))}
    </ul>
  );
}

function Answer({ answer }) {
  const height = trialBandsHeight(answer) + PLOT;
  return (
    <div class={trial.isAsking ? "scroll old" : "scroll"}>
      <Verdict answer={answer} />
      <div class="runs soft">
        <i /> happened <i class="tried" /> what if
      </div>
      <div class="trial" style={{ height: `${height}px` }}>
        <Canvas
          interval={200}
          label="Evidence, states and commands of both runs over time"
          draw={(context, width, tall) => drawTrial(context, answer, limits(), width, tall, theme.isDark)}
        />
      </div>
      <Events answer={answer} />
    </div>
  );
}

function Hint() {
  if (!canTry()) return <p class="empty">{whyNoTrial()}</p>;
  return (
    <div class="empty">
      <p>
        Would another value have been better? The last {trial.seconds} s are replayed with a change, without sending it
        to the robot.
      </p>
      {trial.isOn ? (
        <p>Change a value in the panel Parameters.</p>
      ) : (
        <button class="button" onClick={() => switchTrial(true)}>
          Try parameters
        </button>
      )}
      <p>To try a script, edit it in the panel Scripts, and press “What if” above it.</p>
    </div>
  );
}

function WhatIf() {
  useChanges(300);
  const { answer } = trial;
  return (
    <div class="fill column">
      <div class="row tight">
        <span class="chips grow" role="group" aria-label="Replayed time">
          {SPANS.map((span) => (
            <button
              key={span}
              class="chip small"
              aria-pressed={trial.seconds === span}
              title={store.isLive ? `The last ${span} s` : `${span} s around the shown instant`}
              onClick={() => setSeconds(span)}
            >
              {span} s
            </button>
          ))}
        </span>
        {trial.isAsking && (
          <span class="soft" role="status">
            Replaying…
          </span>
        )}
        <button class="button" disabled={!isTrying() || !canTry()} onClick={askAgain} title="Replay the latest seconds">
          Again
        </button>
      </div>
      {isTrying() && <Tried />}
      {trial.failure && <div class="row tight fault">{trial.failure}</div>}
      {!trial.failure && (answer ? <Answer answer={answer} /> : <Hint />)}
    </div>
  );
}

export default { id: "what_if", title: "What if", area: "left", key: "w", Component: WhatIf };
