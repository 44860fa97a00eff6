// SPDX-License-Identifier: MIT
// Opens a script in its panel at a line, from another panel.
import { openPanel } from "../layout.js";
import { goTo, openScript, workplace } from "./workplace.js";

export async function openAt(file, line) {
  openPanel("scripts");
  await openScript(file);
  await new Promise(requestAnimationFrame); // the panel is drawn
  await new Promise(requestAnimationFrame);
  if (workplace.open?.file === file && line > 0) goTo({ line, column: 0 });
}
