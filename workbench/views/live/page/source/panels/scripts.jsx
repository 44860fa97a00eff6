// SPDX-License-Identifier: MIT
// The scripts of the run: a list with search, and an editor with the findings of the check and the result of each save.
import { useEffect, useRef, useState } from "preact/hooks";

import { seconds } from "../format.js";
import { isRunPaused } from "../operator.js";
import { canCall, link, whyGone } from "../robot.js";
import {
  canSave,
  closeScript,
  editorElement,
  findingsOf,
  goTo,
  goToOpenedLine,
  isEdited,
  listFiles,
  look,
  openScript,
  save,
  updateResult,
  workplace,
} from "../scripts/workplace.js";
import { SearchBox } from "../search_box.jsx";
import { canTry, tryScript } from "../trial.js";
import { useChanges } from "../ticker.js";

const LOOK = 2000; // ms between two looks at the disk

function Files() {
  const [search, setSearch] = useState("");
  const text = search.toLowerCase();
  const files = (workplace.files ?? []).filter((file) => file.toLowerCase().includes(text));
  return (
    <div class="fill column">
      <div class="row pad">
        <SearchBox placeholder="Search the scripts" value={search} onSearch={setSearch} />
      </div>
      {workplace.problem && <div class="fault pad">{workplace.problem}</div>}
      <ul class="scroll files">
        {files.map((file) => (
          <li key={file}>
            <button class="plain" onClick={() => openScript(file)}>
              <code>{file}</code>
            </button>
            {isEdited(file) && <span class="badge">not saved</span>}
          </li>
        ))}
        {workplace.files && !files.length && <li class="empty">No script matches.</li>}
      </ul>
    </div>
  );
}

const whyReadOnly = () =>
  link.state === "open" ? link.refusal || "this robot does not save scripts." : "the connection is closed.";

/// What became of the last save.
function Result({ script }) {
  const { result, file } = script;
  if (script.isSaving) return <div class="row tight soft">Saving…</div>;
  if (script.savedAt === undefined) return null;
  if (file.startsWith("tests/")) return <div class="row tight good">Saved. Run it with reorient test.</div>;
  if (!result) {
    const next = isRunPaused()
      ? "The run is paused: it loads the edit with the next frame."
      : "The run has not reported the edit yet.";
    return <div class="row tight soft">Saved. {next}</div>;
  }
  if (result.accepted) return <div class="row tight good">The edit is running since {seconds(result.time)}.</div>;
  const { finding } = result;
  return (
    <div class="row tight fault" role="alert">
      <span>
        The run refused the edit and keeps the last good version:{" "}
        <b>
          {finding.file}:{finding.line}
        </b>{" "}
        {finding.message}
      </span>
    </div>
  );
}

function OnDisk({ script }) {
  if (script.disk === null) return null;
  return (
    <div class="notice" role="alert">
      The file has changed on the disk, for example by another viewer.{" "}
      <button class="button" onClick={() => script.take(script.disk)}>
        Load it, drop my edits
      </button>{" "}
      <button class="button" onClick={() => script.keepMine()}>
        Keep mine for the next save
      </button>
    </div>
  );
}

function Findings({ script }) {
  const findings = findingsOf(script);
  if (script.checkFailure) return <div class="row tight fault">The check failed: {script.checkFailure}</div>;
  if (!findings.length) return null;
  return (
    <ul class="findings" aria-label="Findings">
      {findings.map((finding, i) => (
        <li key={`${i} ${finding.message}`}>
          <button class={finding.severity === "error" ? "plain bad" : "plain"} onClick={() => goTo(finding)}>
            {finding.line}
            {finding.column ? `:${finding.column}` : ""} {finding.severity}: {finding.message}
          </button>
        </li>
      ))}
    </ul>
  );
}

function OpenScript({ script }) {
  const place = useRef(null);
  useEffect(() => {
    place.current.append(editorElement);
  }, []);
  useEffect(goToOpenedLine);
  const onKeyDown = (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.key !== "s") return;
    event.preventDefault();
    save();
  };
  return (
    <div class="fill column" onKeyDown={onKeyDown}>
      <div class="row tight">
        <button class="button" onClick={closeScript} title="Show all scripts">
          ‹ Scripts
        </button>
        <code class="grow script-name" title={script.file}>
          {script.file}
        </code>
        {script.isChanged && <span class="badge">not saved</span>}
        {canTry() && (
          <button
            class="button"
            disabled={!script.isChanged}
            title="Replay the last seconds with this text, without saving it"
            onClick={() => tryScript(script.file, script.text)}
          >
            What if
          </button>
        )}
        {canSave() && (
          <>
            <button class="button" disabled={!script.isChanged || script.isSaving} title="Save (Ctrl-S)" onClick={save}>
              Save
            </button>
            <button
              class="button"
              disabled={!script.isChanged}
              title="Show the text of the disk again; Ctrl-Z undoes it"
              onClick={() => script.revert()}
            >
              Revert
            </button>
          </>
        )}
      </div>
      {!canSave() && <div class="row tight soft">Read-only: {whyReadOnly()}</div>}
      <OnDisk script={script} />
      {script.notice && <div class="row tight soft">{script.notice}</div>}
      {script.failure && <div class="row tight fault">{script.failure}</div>}
      <div key="stage" class="stage" ref={place} />
      <Findings script={script} />
      <Result script={script} />
    </div>
  );
}

function Scripts() {
  useChanges(250);
  const isOffered = canCall("scripts") && canCall("script");
  updateResult();
  useEffect(() => {
    if (isOffered) listFiles();
    const timer = setInterval(look, LOOK);
    return () => clearInterval(timer);
  }, [isOffered]);
  const { open } = workplace;
  if (open) return <OpenScript script={open} />;
  if (!isOffered) return <p class="empty">{whyGone() || "This robot does not show its scripts."}</p>;
  return <Files />;
}

export default { id: "scripts", title: "Scripts", area: "left", key: "0", Component: Scripts };
