// SPDX-License-Identifier: MIT
// The text editor of the panel Scripts: CodeMirror with Lua. It is a bundle of its own, editor.js, which is loaded when
// a script is opened. It must be in a shadow root: only there CodeMirror adds its styles without <style> elements,
// which the Content-Security-Policy refuses.
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import {
  HighlightStyle,
  StreamLanguage,
  bracketMatching,
  indentOnInput,
  indentUnit,
  syntaxHighlighting,
} from "@codemirror/language";
import { lua } from "@codemirror/legacy-modes/mode/lua";
import { lintGutter, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { Compartment, EditorState } from "@codemirror/state";
import {
  EditorView,
  drawSelection,
  highlightActiveLine,
  highlightSpecialChars,
  keymap,
  lineNumbers,
  tooltips,
} from "@codemirror/view";
import { tags } from "@lezer/highlight";

import { rangeOf } from "./position.js";

const STYLE = EditorView.theme({
  "&": { height: "100%", color: "var(--ink)", backgroundColor: "var(--field)", fontSize: "12px" },
  "&.cm-focused": { outline: "none" },
  ".cm-scroller": { fontFamily: 'ui-monospace, Menlo, Consolas, "DejaVu Sans Mono", monospace', lineHeight: "1.45" },
  ".cm-content": { caretColor: "var(--ink)" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  ".cm-gutters": { backgroundColor: "var(--faint)", color: "var(--soft)", borderRight: "1px solid var(--rule)" },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "var(--faint)" },
  "& .cm-selectionBackground, &.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground": {
    backgroundColor: "var(--blue-soft)",
  },
  ".cm-selectionMatch, &.cm-focused .cm-matchingBracket, .cm-searchMatch": { backgroundColor: "var(--amber-band)" },
  ".cm-searchMatch.cm-searchMatch-selected": { backgroundColor: "var(--good-band)" },
  ".cm-panels, .cm-tooltip": { backgroundColor: "var(--paper)", color: "var(--ink)", borderColor: "var(--rule)" },
  ".cm-tooltip": { maxWidth: "min(480px, 90%)" },
  ".cm-textfield": { backgroundColor: "var(--field)", borderColor: "var(--rule)" },
  ".cm-button": { backgroundImage: "none", backgroundColor: "var(--field)", borderColor: "var(--rule)" },
});

const COLORS = HighlightStyle.define([
  { tag: tags.keyword, color: "var(--blue)" },
  { tag: tags.string, color: "var(--good)" },
  { tag: [tags.number, tags.atom, tags.bool], color: "var(--amber)" },
  { tag: tags.comment, color: "var(--soft)", fontStyle: "italic" },
]);

/// Replaces a selection without the browser, which would wrap the typed text in an element with a style: the
/// Content-Security-Policy refuses that, too.
function typeOverSelection(event, view) {
  const { state } = view;
  const isTyped = event.inputType === "insertText" && !event.isComposing;
  if (!isTyped || state.readOnly || state.selection.main.empty) return false;
  view.dispatch(state.replaceSelection(event.data ?? ""), { userEvent: "input.type", scrollIntoView: true });
  event.preventDefault();
  return true;
}

const language = StreamLanguage.define(lua);

export class Editor {
  /// `root`: a shadow root. `onText(text)` is called after each change, `onSave()` for Ctrl-S.
  constructor(root, { onText, onSave }) {
    this.access = new Compartment();
    this.extensions = [
      lineNumbers(),
      lintGutter(),
      highlightSpecialChars(),
      history(),
      drawSelection(),
      indentOnInput(),
      bracketMatching(),
      highlightActiveLine(),
      highlightSelectionMatches(),
      search({ top: true }),
      tooltips({ position: "absolute" }),
      language,
      syntaxHighlighting(COLORS),
      indentUnit.of("  "),
      // Other line ends stay in the text, so that saving changes only what was typed.
      EditorState.lineSeparator.of("\n"),
      EditorView.clipboardInputFilter.of((text) => text.replaceAll("\r\n", "\n")),
      EditorView.contentAttributes.of({ "aria-label": "Script", spellcheck: "false" }),
      EditorView.domEventHandlers({ beforeinput: typeOverSelection }),
      keymap.of([
        { key: "Mod-s", preventDefault: true, run: () => (onSave(), true) },
        indentWithTab,
        ...searchKeymap,
        ...lintKeymap,
        ...historyKeymap,
        ...defaultKeymap,
      ]),
      EditorView.updateListener.of((update) => {
        if (update.docChanged) onText(update.state.sliceDoc());
      }),
      STYLE,
    ];
    this.view = new EditorView({ root, parent: root });
  }

  /// The state of a text that is opened: with its own undo and selection.
  begin(text) {
    return EditorState.create({ doc: text, extensions: [this.extensions, this.access.of([])] });
  }

  get state() {
    return this.view.state;
  }

  show(state) {
    this.view.setState(state);
  }

  setReadOnly(isReadOnly) {
    this.view.dispatch({ effects: this.access.reconfigure(EditorState.readOnly.of(isReadOnly)) });
  }

  /// Replaces the text. Undo returns to the text before.
  replace(text) {
    const { state } = this.view;
    if (state.sliceDoc() === text) return;
    const anchor = Math.min(state.selection.main.head, text.length);
    this.view.dispatch({ changes: { from: 0, to: state.doc.length, insert: text }, selection: { anchor } });
  }

  /// Marks findings: {line, column, severity, message}.
  mark(findings) {
    const { doc } = this.view.state;
    const diagnostics = findings.map(({ line, column, severity, message }) => {
      const at = doc.line(Math.min(Math.max(line, 1), doc.lines));
      const { from, to } = rangeOf(at.text, column);
      return { from: at.from + from, to: at.from + to, severity, message };
    });
    this.view.dispatch(setDiagnostics(this.view.state, diagnostics));
  }

  /// Moves the cursor to a line.
  goTo(line, column) {
    const { doc } = this.view.state;
    const at = doc.line(Math.min(Math.max(line, 1), doc.lines));
    this.view.dispatch({ selection: { anchor: at.from + rangeOf(at.text, column).from }, scrollIntoView: true });
    this.view.focus();
  }
}
