// SPDX-License-Identifier: MIT
// Notes that go into the recording at the present time of the robot, and all notes of the stored time.
import { useState } from "preact/hooks";

import { fixed } from "../format.js";
import { isRunPaused } from "../operator.js";
import { call, canCall, link, store, whyGone } from "../robot.js";
import { useChanges } from "../ticker.js";

function Notes() {
  useChanges(250);
  const [text, setText] = useState("");
  const [failure, setFailure] = useState("");
  const [sent, setSent] = useState([]); // texts without an answer
  const notes = store.events.filter((event) => event.kind === "note").reverse();
  const send = async (event) => {
    event.preventDefault();
    const note = { text: text.trim() };
    if (!note.text) return;
    setText("");
    setFailure("");
    setSent((all) => [note, ...all]);
    try {
      await call("note", note);
    } catch (error) {
      setFailure(`The note “${note.text}” was not stored: ${error.message}`);
      setText((typed) => typed || note.text);
    }
    setSent((all) => all.filter((it) => it !== note));
  };
  return (
    <div class="fill column">
      {canCall("note", true) && (
        <form class="row pad" onSubmit={send}>
          <input
            id="note"
            class="grow"
            type="text"
            maxlength="500"
            placeholder="What do you see? Press Enter."
            aria-label="Note"
            value={text}
            onInput={(event) => setText(event.currentTarget.value)}
          />
          <button class="button" disabled={!text.trim()}>
            Add
          </button>
        </form>
      )}
      {failure && <div class="fault pad">{failure}</div>}
      <ol class="scroll log">
        {isRunPaused() &&
          sent.map((note, i) => (
            <li key={`sent ${i}`}>
              <span>{note.text}</span>
              <span class="badge" title="The run is paused. It stores the note when it runs a frame.">
                from the next frame on
              </span>
            </li>
          ))}
        {notes.map((note) => (
          <li key={`${note.time} ${note.text}`}>
            <button class="plain time" title="Show this instant" onClick={() => store.show(note.time)}>
              {fixed(note.time, 2)}
            </button>
            <span>
              {note.machine !== "note" && <b>{note.machine} </b>}
              {note.text}
            </span>
          </li>
        ))}
        {!notes.length && !sent.length && (
          <li class="empty">
            {canCall("note", true)
              ? "No notes yet. A note is stored in the recording with the time of the robot."
              : link.refusal || whyGone() || "This robot takes no notes from the page."}
          </li>
        )}
      </ol>
    </div>
  );
}

export default { id: "notes", title: "Notes", area: "right", key: "8", Component: Notes };
