// SPDX-License-Identifier: MIT
// The parameters: search, sliders and numbers with range, unit and description; undo; differences.
import { useRef, useState } from "preact/hooks";

import { entered, seconds } from "../format.js";
import { isRunPaused } from "../operator.js";
import { filtersOf, listed, whyEmpty } from "../parameter_list.js";
import { call, canCall, canSetParameters, link, parameters, setParameter, undoParameter } from "../robot.js";
import { SearchBox } from "../search_box.jsx";
import { useChanges } from "../ticker.js";
import { canTry, dropParameter, isTrying, showAnswer, switchTrial, trial, tryParameter, whyNoTrial } from "../trial.js";

const LONGEST_LIST = 120;
const SEND_INTERVAL = 100; // ms, while a slider moves

const isRange = ({ min, max, value }) =>
  typeof value === "number" && Number.isFinite(min) && Number.isFinite(max) && max > min;

/// The position of a slider, in thousandths. Wide positive ranges are logarithmic.
function scaleOf({ min, max }) {
  const isWide = min > 0 && max / min > 500;
  return isWide
    ? {
        position: (value) => (1000 * Math.log(value / min)) / Math.log(max / min),
        value: (at) => min * (max / min) ** (at / 1000),
      }
    : { position: (value) => (1000 * (value - min)) / (max - min), value: (at) => min + ((max - min) * at) / 1000 };
}

/// The value now, which is newer than the one that the list was drawn with; of a what-if the tried one.
const present = ({ name }) =>
  (trial.isOn ? trial.parameters.get(name) : undefined) ?? parameters.all.get(name)?.value;

/// Sets the value on the robot, or only tries it.
function send(name, value) {
  if (trial.isOn) tryParameter(name, value);
  else setParameter(name, value);
}

function Slider({ parameter, disabled }) {
  const last = useRef(0);
  const [moving, setMoving] = useState(null); // the position while the user moves the slider
  const scale = scaleOf(parameter);
  const valueAt = (event) => {
    const { min, max } = parameter;
    const value = Number(scale.value(Number(event.currentTarget.value)).toPrecision(3));
    return Math.min(max, Math.max(min, parameter.type === "integer" ? Math.round(value) : value));
  };
  const move = (event) => {
    setMoving(event.currentTarget.value);
    const now = performance.now();
    if (now - last.current < SEND_INTERVAL) return;
    last.current = now;
    send(parameter.name, valueAt(event));
  };
  const finish = (event) => {
    const value = valueAt(event);
    if (value !== present(parameter)) send(parameter.name, value);
    parameters.settle();
    setMoving(null);
  };
  return (
    <input
      type="range"
      min="0"
      max="1000"
      step="1"
      value={moving ?? Math.round(scale.position(present(parameter)))}
      disabled={disabled}
      aria-label={`${parameter.name} as a slider`}
      onInput={move}
      onChange={finish}
    />
  );
}

function Value({ parameter, disabled }) {
  const { name } = parameter;
  const value = present(parameter);
  const draft = useRef(null); // the text while the user edits it
  const [, draw] = useState(0);
  const edit = (text) => {
    draft.current = text;
    draw((count) => count + 1);
  };
  const sendOne = (next) => {
    send(name, next);
    parameters.settle();
  };
  if (typeof value === "boolean") {
    const change = (event) => sendOne(event.currentTarget.checked);
    return <input type="checkbox" checked={value} disabled={disabled} aria-label={name} onChange={change} />;
  }
  if (parameter.choices) {
    return (
      <select value={value} disabled={disabled} aria-label={name} onChange={(event) => sendOne(event.currentTarget.value)}>
        {parameter.choices.map((choice) => (
          <option key={choice}>{choice}</option>
        ))}
      </select>
    );
  }
  const isNumber = typeof value === "number";
  const commit = () => {
    if (draft.current === null) return;
    const text = draft.current.trim();
    edit(null);
    const number = Number(text.replace("−", "-"));
    if (isNumber && (text === "" || !Number.isFinite(number))) return; // the value stays
    if (text !== entered(value)) sendOne(isNumber ? number : text);
  };
  const key = (event) => {
    if (event.key === "Enter") commit();
    if (event.key === "Escape") edit(null);
  };
  return (
    <input
      type="text"
      inputmode={isNumber ? "decimal" : "text"}
      value={draft.current ?? entered(value ?? "")}
      disabled={disabled}
      aria-label={name}
      onInput={(event) => edit(event.currentTarget.value)}
      onBlur={commit}
      onKeyDown={key}
    />
  );
}

function Parameter({ parameter, disabled }) {
  const { name, unit, min, max, description, origin } = parameter;
  const refusal = parameters.refusals.get(name);
  const isChanged = parameters.differs(parameter, "default");
  const isLater = isRunPaused() && parameters.pending.has(name);
  const range = isRange(parameter) ? `${entered(min)} to ${entered(max)}` : "";
  return (
    <li class={isChanged ? "parameter changed" : "parameter"}>
      <div class="row">
        <code class="grow">{name}</code>
        <Value parameter={parameter} disabled={disabled} />
        <span class="unit">{unit}</span>
      </div>
      {isRange(parameter) && <Slider parameter={parameter} disabled={disabled} />}
      {description && <div class="description">{description}</div>}
      <div class="facts">
        {isLater && (
          <span class="badge" title="The run is paused. The robot has the value before until it runs a frame.">
            from the next frame on
          </span>
        )}
        {range && (
          <span>
            {range}
            {unit ? ` ${unit}` : ""}
          </span>
        )}
        {parameter.default !== undefined && <span>default {entered(parameter.default)}</span>}
        {parameters.differs(parameter, "file") && (
          <span>
            in {parameters.file.name} {entered(parameters.inFile(parameter))}
          </span>
        )}
        {parameters.differs(parameter, "start") && <span>at the start {entered(parameters.start.get(name))}</span>}
        {origin && <span>from {origin}</span>}
        {isChanged && !disabled && (
          <button
            class="link"
            onClick={() => {
              send(name, parameter.default);
              parameters.settle();
            }}
          >
            set to default
          </button>
        )}
      </div>
      {trial.parameters.has(name) && (
        <div class="facts">
          <span class="badge">
            what if {entered(trial.parameters.get(name))}; the robot has {entered(parameters.all.get(name)?.value ?? "–")}
          </span>
          <button class="link" onClick={() => dropParameter(name)}>
            drop
          </button>
        </div>
      )}
      {refusal && <div class="fault">{refusal}</div>}
    </li>
  );
}

/// Saves what differs from the defaults, and compares with such a file.
function ParameterFile({ disabled, onCompare }) {
  const [file, setFile] = useState("tuned.toml");
  const [outcome, setOutcome] = useState(null); // {text, isGood}
  const attempt = async (service, report) => {
    try {
      setOutcome({ text: report(await call(service, { file })), isGood: true });
    } catch (error) {
      setOutcome({ text: error.message, isGood: false });
    }
  };
  const save = () =>
    attempt("save", ({ backup }) => `Saved in ${file}.${backup ? ` The file before is ${backup}.` : ""}`);
  const compare = () =>
    attempt("file_parameters", (answer) => {
      parameters.takeFile(answer);
      onCompare();
      return `Compared with ${file}.`;
    });
  return (
    <details class="parameter-file">
      <summary>Save or compare with a file</summary>
      <div class="row tight">
        <input
          type="text"
          class="grow"
          value={file}
          aria-label="File of parameters"
          onInput={(event) => setFile(event.currentTarget.value.trim())}
        />
        <button
          class="button"
          disabled={disabled || !canCall("save", true)}
          title="Save the parameters that differ from their defaults"
          onClick={save}
        >
          Save
        </button>
        <button class="button" disabled={!canCall("file_parameters")} onClick={compare}>
          Compare
        </button>
      </div>
      {outcome && (
        <div class={outcome.isGood ? "row tight good" : "row tight fault"} role="status">
          {outcome.text}
        </div>
      )}
    </details>
  );
}

/// Why nothing is listed, with a way back to all parameters.
function Empty({ filter, search, onShowAll }) {
  return (
    <li class="empty" role="status">
      {whyEmpty(parameters, filter, search)}
      {parameters.all.size > 0 && (
        <button class="button" onClick={onShowAll}>
          Show all parameters
        </button>
      )}
    </li>
  );
}

/// Who receives the values, while a what-if is on, and its first result. It may be out of sight on a phone.
function TrialNotice() {
  const { answer, failure, isAsking } = trial;
  const decision = answer?.first_decision;
  const found = decision ? `the first decision that differs is at ${seconds(decision.time)}.` : "no decision differs.";
  return (
    <div class="trial-notice" role="status">
      <span class="grow">
        <b>What if:</b>{" "}
        {isTrying()
          ? failure || (isAsking || !answer ? "replaying…" : found)
          : `change a value, and the last ${trial.seconds} s are replayed with it. The robot keeps its own.`}
      </span>
      {isTrying() && (
        <button class="link" title="Show the answer in the panel What if (W)" onClick={showAnswer}>
          show
        </button>
      )}
    </div>
  );
}

function ParametersPanel() {
  useChanges(200);
  const [search, setSearch] = useState("");
  const [filter, setFilter] = useState("all");
  const disabled = !canSetParameters();
  const filters = filtersOf(parameters);
  const chosen = filters.some(({ id }) => id === filter) ? filter : "all";
  const found = listed(parameters, chosen, search);
  const showWhole = (which) => {
    setSearch("");
    setFilter(which);
  };
  const last = parameters.undos.at(-1);
  return (
    <div class={trial.isOn ? "fill column trying" : "fill column"}>
      <div class="row pad">
        <SearchBox
          placeholder="Search a name or description"
          label="Search parameters"
          value={search}
          onSearch={setSearch}
        />
        <button
          class="button"
          disabled={!last || disabled}
          title={last ? `Set ${last.name} to ${entered(last.value)} again` : "Nothing to undo"}
          onClick={undoParameter}
        >
          Undo
        </button>
        <button
          class="button what-if"
          aria-pressed={trial.isOn}
          disabled={!canTry()}
          title={whyNoTrial() || "Try values on the last seconds, without sending them to the robot"}
          onClick={() => switchTrial()}
        >
          {trial.isOn ? "End what-if" : "What if…"}
        </button>
      </div>
      {trial.isOn && <TrialNotice />}
      <div class="chips" role="group" aria-label="Which parameters">
        {filters.map(({ id, name, count }) => (
          <button key={id} class="chip" aria-pressed={chosen === id} onClick={() => setFilter(id)}>
            {name}
            {id === "all" ? "" : ` (${count})`}
          </button>
        ))}
        {disabled && (
          <span class="soft" title={link.refusal}>
            read-only
          </span>
        )}
      </div>
      <ParameterFile disabled={disabled} onCompare={() => showWhole("file")} />
      <ul class="scroll parameters">
        {found.slice(0, LONGEST_LIST).map((parameter) => (
          <Parameter key={parameter.name} parameter={parameter} disabled={disabled} />
        ))}
        {found.length > LONGEST_LIST && (
          <li class="soft pad">{found.length - LONGEST_LIST} more; search for a name.</li>
        )}
        {!found.length && <Empty filter={chosen} search={search} onShowAll={() => showWhole("all")} />}
      </ul>
    </div>
  );
}

export default { id: "parameters", title: "Parameters", area: "right", key: "5", Component: ParametersPanel };
