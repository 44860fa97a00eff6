// SPDX-License-Identifier: MIT
// Reduced rates in the header: what is left out and why, and how old the shown frame is.
import { seconds } from "./format.js";
import { Lateness, followBrowser, rateText } from "./lateness.js";
import { isReplay, link, store } from "./robot.js";

const RECENT_DROPS = 10000; // ms
const OLD = 700; // ms
const DROPPED =
  "Too many messages waited for this page: the connection is slow, or this computer is busy. The robot drops images first.";
const browser = new Lateness();
followBrowser(browser);

/// The age in s of the newest frame, if it is old and a newer one is expected; null: it is not.
function age(now) {
  if (isReplay() || !link.framed) return null;
  return now - link.framed > OLD ? (now - link.framed) / 1000 : null;
}

export function Slowness() {
  if (link.state !== "open" || store.isStill) return null; // no frames are expected
  const now = Date.now();
  const old = link.slow && store.isLive ? age(now) : null;
  const dropped = link.drops > 0 && now - link.lastDrop < RECENT_DROPS;
  const { text, title } = rateText(link.slow, browser.isBusy);
  const badges = [];
  if (text) badges.push({ text, title });
  if (dropped) badges.push({ text: `${link.drops}× messages dropped`, title: DROPPED });
  return (
    <>
      {old !== null && <span class="value soft">{seconds(old, 1)} old</span>}
      {badges.length > 0 && (
        <span class="badge" title={badges.map((badge) => badge.title).join("\n")}>
          {badges.map((badge) => badge.text).join("; ")}
        </span>
      )}
    </>
  );
}
