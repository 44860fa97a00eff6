// SPDX-License-Identifier: MIT
// The scripts that are open on this page, and the editor that shows one of them. They stay when another panel is shown.
import { call, canCall, isReplay, link, store } from "../robot.js";
import { changedByUser } from "../ticker.js";
import { EditedScript } from "./edited_script.js";
import { findingOf, reloadResult } from "./reload_result.js";

const EDITOR = "/editor.js";

/// files: null before they are listed; open: the shown EditedScript; line: where the cursor goes when the panel is drawn,
/// or 0; problem: why there is no list or no editor.
export const workplace = { files: null, open: null, line: 0, problem: "" };

const scripts = new Map(); // file: EditedScript
let editor = null; // made with the first script
let marked = null; // the findings that the editor shows

/// The element of the editor, with a shadow root.
const host = document.createElement("div");
host.className = "editor";
// The page's own keys are for the rest of the page.
host.addEventListener("keydown", (event) => event.stopPropagation());
export const editorElement = host;

addEventListener("beforeunload", (event) => {
  if ([...scripts.values()].some((script) => script.isChanged)) event.preventDefault();
});

export const canSave = () => canCall("save_script", true);
export const isEdited = (file) => scripts.get(file)?.isChanged ?? false;

export async function listFiles() {
  try {
    workplace.files = (await call("scripts", {})).files;
    workplace.problem = "";
  } catch (error) {
    workplace.problem = `The list of scripts is missing: ${error.message}`;
  }
  changedByUser();
}

async function loadEditor() {
  if (editor) return;
  const { Editor } = await import(EDITOR);
  editor ??= new Editor(host.attachShadow({ mode: "open" }), {
    onText: (text) => workplace.open?.typed(text),
    onSave: save,
  });
}

/// `line`: where the cursor goes, 0: where it was.
export async function openScript(file, line = 0) {
  try {
    await loadEditor();
    if (!scripts.has(file)) await begin(file);
    leave();
    workplace.open = scripts.get(file);
    workplace.line = line;
    editor.show(workplace.open.state);
    marked = null;
    workplace.problem = "";
    refresh();
  } catch (error) {
    workplace.problem = `${file} cannot be opened: ${error.message}`;
  }
  changedByUser();
}

async function begin(file) {
  const { text } = await call("script", { file });
  const replace = (other) => replaceText(file, other);
  const script = new EditedScript(file, text, { call, onChange: refresh, replace });
  script.state = editor.begin(text);
  script.result = null;
  scripts.set(file, script);
  if (canCall("check_script")) script.checkIn(0);
  else script.checkIn = () => {};
}

function replaceText(file, text) {
  if (workplace.open?.file === file) editor.replace(text);
  else scripts.get(file).state = editor.begin(text);
}

function leave() {
  if (workplace.open) workplace.open.state = editor.state;
}

/// Shows the list. A script with edits stays open.
export function closeScript() {
  leave();
  const script = workplace.open;
  if (script && !script.isChanged) {
    script.close();
    scripts.delete(script.file);
  }
  workplace.open = null;
  listFiles();
}

export async function save() {
  const script = workplace.open;
  if (!script || !canSave()) return;
  const since = store.newest;
  if (!(await script.save())) return;
  script.savedAt = since;
  script.result = null;
  changedByUser();
  if (isReplay()) await reloadNow(script);
}

/// A replay does not watch files.
async function reloadNow(script) {
  try {
    const { scripts: results } = await call("reload", { script: script.file });
    const refused = results.find((it) => !it.accepted);
    script.result = {
      time: store.newest,
      accepted: !refused,
      finding: refused ? findingOf(refused.problem, script.file) : null,
    };
  } catch (error) {
    script.failure = `The script was saved, but not reloaded: ${error.message}`;
  }
  refresh();
}

/// What became of the last save of the shown script, from the log.
export function updateResult() {
  const script = workplace.open;
  if (!script || script.savedAt === undefined || isReplay()) return;
  const result = reloadResult(store.log, script.file, script.savedAt);
  if (!result || (result.time === script.result?.time && result.accepted === script.result.accepted)) return;
  script.result = result;
  refresh();
}

/// The findings of the check, and the fault of the run until the text is changed.
export function findingsOf(script) {
  const fault = script.result?.finding;
  if (fault?.file !== script.file || script.isChanged) return script.findings;
  const isSame = (it) => it.line === fault.line && it.message === fault.message;
  return script.findings.some(isSame) ? script.findings : [fault, ...script.findings];
}

function refresh() {
  const script = workplace.open;
  if (script && editor) {
    const findings = findingsOf(script);
    const key = JSON.stringify(findings);
    if (key !== marked) editor.mark(findings);
    marked = key;
    const isReadOnly = !canSave();
    if (editor.state.readOnly !== isReadOnly) editor.setReadOnly(isReadOnly);
  }
  changedByUser();
}

export const goTo = (finding) => editor.goTo(finding.line, finding.column);

/// To be called when the editor is in the page: only then it scrolls and takes the focus.
export function goToOpenedLine() {
  if (workplace.line > 0) goTo({ line: workplace.line, column: 0 });
  workplace.line = 0;
}

/// Regularly: compares with the disk, and with what this page may do.
export function look() {
  if (link.state !== "open") return;
  workplace.open?.look();
  if (editor && workplace.open && editor.state.readOnly === canSave()) refresh();
}
