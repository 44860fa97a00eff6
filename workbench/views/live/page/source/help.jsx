// SPDX-License-Identifier: MIT
// The list of keys.
import { useEffect, useRef } from "preact/hooks";

import { PoseMark } from "./draw/pose_marks.jsx";
import { KEYS } from "./keys.js";

export function Help({ onClose }) {
  const dialog = useRef(null);
  useEffect(() => {
    dialog.current.showModal();
  }, []);
  return (
    <dialog ref={dialog} onClose={onClose} onClick={(event) => event.target === dialog.current && onClose()}>
      <h2>Keys</h2>
      <dl>
        {KEYS.map(([key, text]) => [
          <dt key={key}>
            <kbd>{key}</kbd>
          </dt>,
          <dd key={text}>{text}</dd>,
        ])}
      </dl>
      <p class="soft">
        <PoseMark kind="belief" /> blue is the believed pose, <PoseMark kind="mirrored" /> red the mirrored pose,{" "}
        <PoseMark kind="truth" /> amber the true pose if it is known, magenta the belief of the view.
      </p>
      <button class="button" onClick={onClose}>
        Close
      </button>
    </dialog>
  );
}
