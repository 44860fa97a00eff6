// SPDX-License-Identifier: MIT
// Where each panel is: areas of the page with tabs. The user moves and hides panels; the layout is kept in the
// settings.
import { panels } from "./panels/index.js";
import { set, settings } from "./settings.js";

export const AREAS = [
  ["left", "left"],
  ["middle", "middle, top"],
  ["below", "middle, bottom"],
  ["right", "right"],
  ["bottom", "bottom"],
];

const areaOf = (panel) => settings.areas[panel.id] ?? panel.area;

/// The visible panels of an area, and the one of them that is open: {all, open}.
export function contentsOf(area) {
  const all = panels.filter((panel) => areaOf(panel) === area && !settings.hidden.includes(panel.id));
  return { all, open: all.find((panel) => panel.id === settings.open[area]) ?? all[0] };
}

/// Opens a panel in its area, and shows it if it was hidden.
export function openPanel(id) {
  const panel = panels.find((it) => it.id === id);
  set({ hidden: settings.hidden.filter((it) => it !== id), open: { ...settings.open, [areaOf(panel)]: id } });
}

export function movePanel(id, area) {
  set({ areas: { ...settings.areas, [id]: area }, open: { ...settings.open, [area]: id } });
}

export function hidePanel(id) {
  set({ hidden: [...settings.hidden, id] });
}

export function resetLayout() {
  set({ areas: {}, hidden: [], open: {} });
}
