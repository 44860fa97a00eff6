// SPDX-License-Identifier: MIT
// The list of keys.
import { useEffect, useRef } from "preact/hooks";

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
        Blue is the believed pose, red the mirrored pose, amber the true pose if it is known, magenta the belief of the
        view.
      </p>
      <button class="button" onClick={onClose}>
        Close
      </button>
    </dialog>
  );
}
