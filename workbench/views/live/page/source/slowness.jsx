// SPDX-License-Identifier: MIT
// The state of a slow connection in the header: what is left out, and how old the shown frame is.
import { seconds } from "./format.js";
import { isReplay, link, store } from "./robot.js";

const RECENT =
  "The robot sends fewer frames and images, so that what arrives is recent. Events and log lines all arrive.";
const RECENT_DROPS = 10000; // ms
const OLD = 700; // ms

/// The age in s of the newest frame, if it is old and a newer one is expected; null: it is not.
function age(now) {
  if (link.state !== "open" || isReplay() || store.isStill || !link.framed) return null;
  return now - link.framed > OLD ? (now - link.framed) / 1000 : null;
}

export function Slowness() {
  if (link.state !== "open") return null;
  const now = Date.now();
  const old = link.slow && store.isLive ? age(now) : null;
  const dropped = link.drops > 0 && now - link.lastDrop < RECENT_DROPS;
  return (
    <>
      {old !== null && <span class="value soft">{seconds(old, 1)} old</span>}
      {link.slow && (
        <span class="badge" title={`${link.slow}. ${RECENT}`}>
          {link.slow}
        </span>
      )}
      {dropped && (
        <span class="badge" title="The robot left out messages, images first.">
          slow connection, {link.drops}× dropped
        </span>
      )}
    </>
  );
}
