// SPDX-License-Identifier: MIT
// Opens a script in its panel at a line, from another panel.
import { openPanel } from "../layout.js";
import { openScript } from "./workplace.js";

export async function openAt(file, line) {
  openPanel("scripts");
  await openScript(file, line);
}
