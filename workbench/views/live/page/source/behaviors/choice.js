// SPDX-License-Identifier: MIT
// What the user chose in the panel of behaviors. It stays while other panels are shown.
import { useEffect, useRef } from "preact/hooks";

import { changedByUser } from "../ticker.js";

/// machine: a name, or null for the list; state: its index, or null for the active one; focus: what gets the focus once
/// it is drawn: the name of a machine in the list, "title", or null.
export const choice = { machine: null, state: null, isGraphShown: true, focus: null };

export function choose(machine, state = null) {
  if (machine !== choice.machine) choice.focus = machine === null ? choice.machine : "title";
  Object.assign(choice, { machine, state });
  changedByUser();
}

export function toggleGraph() {
  choice.isGraphShown = !choice.isGraphShown;
  changedByUser();
}

/// The ref of an element that gets the focus when the button that had it has gone.
export function useFocus(name) {
  const element = useRef(null);
  useEffect(() => {
    if (choice.focus !== name) return;
    choice.focus = null;
    element.current.focus({ preventScroll: name === "title" });
  });
  return element;
}
