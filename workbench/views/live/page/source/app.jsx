// SPDX-License-Identifier: MIT
// The page: a header with the state of the connection, areas with panels, help.
import { useEffect, useErrorBoundary, useState } from "preact/hooks";

import { Audience, isAudience } from "./audience.jsx";
import { duration, seconds } from "./format.js";
import { Help } from "./help.jsx";
import { enterPanel, onKey } from "./keys.js";
import { AREAS, contentsOf, hidePanel, movePanel, openPanel, resetLayout } from "./layout.js";
import { followRun, isRunPaused } from "./operator.js";
import { Pace } from "./pace.jsx";
import { panels } from "./panels/index.js";
import { replay } from "./replay.js";
import { ReplayPace } from "./replay.jsx";
import { isReplay, limits, link, runEnd, store } from "./robot.js";
import { thought } from "./sentence.js";
import { settings } from "./settings.js";
import { Slowness } from "./slowness.jsx";
import { switchTheme } from "./theme.js";
import { changed, useChanges } from "./ticker.js";
import { onTrial } from "./trial.js";

const STALE = 3000; // ms without a message after which the page says so
const RETRY = 1000; // ms
const LONG = 15000; // ms without a connection

onTrial((id, enters) => (enters ? enterPanel : openPanel)(id));

function connectionText() {
  const now = Date.now();
  if (link.state === "connecting") return { tone: "doubt", text: "Connecting to the robot…" };
  if (link.state === "closed") {
    // The end of a run is no fault.
    if (runEnd()) return { tone: "busy", text: `${runEnd()}. Another run prints another link.` };
    const gone = duration((now - link.since) / 1000);
    const hint = now - link.since > LONG ? " A restarted run prints another link." : "";
    return { tone: "wrong", text: `The robot is gone for ${gone}. Trying again…${hint}` };
  }
  if (isRunPaused()) return { tone: "busy", text: "Run paused" };
  if (!store.frames.length) return { tone: "doubt", text: "Connected. Waiting for data…" };
  if (isReplay() && replay.status === "buffering") return { tone: "busy", text: "Seeking…" };
  if (isReplay() && replay.status === "paused") return { tone: "busy", text: "Replay paused" };
  if (isReplay() && replay.status === "ended") return { tone: "busy", text: "End of the recording" };
  if (now - link.heard > STALE) return { tone: "doubt", text: `No data for ${duration((now - link.heard) / 1000)}` };
  return { tone: "good", text: isReplay() ? "Replay" : "Live" };
}

export function ConnectionState() {
  useChanges(200);
  const { tone, text } = connectionText();
  const shown = store.shown();
  const isPaused = !store.isLive && link.state === "open";
  return (
    <span class={`connection ${isPaused ? "busy" : tone}`} role="status">
      <i class="lamp" />
      <b>{isPaused ? "View paused" : text}</b>
      {shown && <span class="value">{seconds(shown.time)}</span>}
      {isPaused && <span class="soft value">{isReplay() ? "replay" : "robot"} at {seconds(store.newest, 0)}</span>}
      <Slowness />
    </span>
  );
}

export function Thought() {
  useChanges(200);
  const { text, tone } = thought(store, limits());
  return <p class={`thought ${tone}`}>{text}</p>;
}

function Notices() {
  useChanges(500);
  const lines = [...link.notices.values()].filter((notice) => notice.until === undefined || notice.until > Date.now());
  // The user of a link with a token expects to tune.
  if (link.refusal && location.search.includes("token=")) lines.push({ level: 1, message: link.refusal });
  if (store.bad)
    lines.push({ level: 1, message: `${store.bad} messages could not be read or drawn; the last: ${store.badText}` });
  return (
    <div class="notices">
      {lines.map(({ level, message }) => (
        <div key={message} class={level >= 2 ? "notice error" : "notice"} role="alert">
          {message}
        </div>
      ))}
    </div>
  );
}

function PanelMenu() {
  useChanges(500);
  return (
    <details class="menu">
      <summary class="button">Panels</summary>
      <div class="sheet">
        {panels.map(({ id, title, key }) => {
          const isHidden = settings.hidden.includes(id);
          return (
            <label key={id}>
              <input type="checkbox" checked={!isHidden} onChange={() => (isHidden ? openPanel(id) : hidePanel(id))} />
              {title} <kbd>{key}</kbd>
            </label>
          );
        })}
        <button class="link" onClick={resetLayout}>
          Reset the layout
        </button>
      </div>
    </details>
  );
}

function Header({ onHelp }) {
  useChanges(1000);
  const names = { system: "as the system", light: "light", dark: "dark" };
  return (
    <header>
      <ConnectionState />
      <Thought />
      <nav>
        <Pace />
        <ReplayPace />
        <PanelMenu />
        <button
          class="button"
          onClick={switchTheme}
          title={`Colors: ${names[settings.theme]} (T)`}
          aria-label={`Colors: ${names[settings.theme]}`}
        >
          ◐
        </button>
        <a class="button" href="#audience" title="Large and read-only (A)">
          Audience
        </a>
        <button class="button" onClick={onHelp} title="Keys (?)" aria-label="Keys">
          ?
        </button>
      </nav>
    </header>
  );
}

/// A panel that cannot show a message says so, and tries again. The other panels continue.
function Guarded({ Component }) {
  const [error, retry] = useErrorBoundary((failure) => store.fail(failure.message));
  useEffect(() => {
    const timer = error && setTimeout(retry, RETRY);
    return () => clearTimeout(timer);
  }, [error]);
  return error ? <p class="empty">This panel cannot show what the robot sent: {error.message}</p> : <Component />;
}

function Area({ area }) {
  useChanges(1000);
  const { all, open } = contentsOf(area);
  if (!open) return null;
  const move = (event) => {
    const target = event.currentTarget.value;
    event.currentTarget.value = "";
    if (target === "hide") hidePanel(open.id);
    else movePanel(open.id, target);
  };
  return (
    <section class="area" data-area={area} data-panel={open.id} aria-label={open.title} tabIndex={-1}>
      <div class="tabs" role="tablist">
        {all.map((panel) => (
          <button
            key={panel.id}
            role="tab"
            aria-selected={panel === open}
            title={`${panel.title} (${panel.key})`}
            onClick={() => openPanel(panel.id)}
          >
            {panel.title}
          </button>
        ))}
        <select class="move" aria-label={`Move ${open.title}`} title="Move or hide this panel" onChange={move} value="">
          <option value="" disabled hidden>
            ⋯
          </option>
          {AREAS.filter(([id]) => id !== area).map(([id, name]) => (
            <option key={id} value={id}>
              Move to {name}
            </option>
          ))}
          <option value="hide">Hide</option>
        </select>
      </div>
      <div class="panel" key={open.id}>
        <Guarded Component={open.Component} />
      </div>
    </section>
  );
}

function Areas() {
  useChanges(1000);
  const is = (area) => contentsOf(area).all.length > 0;
  return (
    <main>
      <div class="upper">
        <Area area="left" />
        {(is("middle") || is("below")) && (
          <div class="pair">
            <Area area="middle" />
            <Area area="below" />
          </div>
        )}
        <Area area="right" />
      </div>
      <Area area="bottom" />
    </main>
  );
}

export function App() {
  const [audience, setAudience] = useState(isAudience());
  const [help, setHelp] = useState(false);
  useEffect(followRun, []);
  useEffect(() => {
    const navigate = () => setAudience(isAudience());
    const close = () => {
      setHelp(false);
      document.querySelector(".menu")?.removeAttribute("open");
    };
    const actions = { help: () => setHelp((shown) => !shown), close, isAudience };
    const key = (event) => onKey(event, actions);
    const tick = setInterval(changed, 500); // durations on the page advance without messages
    addEventListener("hashchange", navigate);
    addEventListener("keydown", key);
    return () => {
      clearInterval(tick);
      removeEventListener("hashchange", navigate);
      removeEventListener("keydown", key);
    };
  }, []);
  if (audience) return <Audience />;
  return (
    <div class={`page ${link.state === "closed" ? "gone" : ""}`}>
      <Header onHelp={() => setHelp(true)} />
      <Notices />
      <Areas />
      {help && <Help onClose={() => setHelp(false)} />}
    </div>
  );
}
