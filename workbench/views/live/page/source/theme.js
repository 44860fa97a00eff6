// SPDX-License-Identifier: MIT
// Light or dark: follows the system, or the choice of the user.
import { forgetThemeColors } from "./draw/palette.js";
import { set, settings } from "./settings.js";
import { changedByUser } from "./ticker.js";

const system = matchMedia("(prefers-color-scheme: dark)");

/// version: increases whenever colors change.
export const theme = { isDark: false, version: 0 };

export function applyTheme() {
  theme.isDark = settings.theme === "dark" || (settings.theme === "system" && system.matches);
  document.documentElement.dataset.theme = theme.isDark ? "dark" : "light";
  ++theme.version;
  forgetThemeColors();
  changedByUser();
}

/// The next of: as the system, light, dark.
export function switchTheme() {
  const next = { system: "light", light: "dark", dark: "system" };
  set({ theme: next[settings.theme] ?? "system" });
  applyTheme();
}

system.addEventListener("change", applyTheme);
