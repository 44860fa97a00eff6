// SPDX-License-Identifier: MIT
// One time axis: evidence, confidences, status, states of the chosen behaviors, commands, edits and notes. A click
// shows an instant in every panel. The view pauses, not the robot.
import { useEffect, useRef } from "preact/hooks";

import { bandsHeight, drawBands, isReorientation, marksOf } from "../draw/bands.js";
import { Canvas } from "../draw/canvas.jsx";
import { themeColor } from "../draw/palette.js";
import { GUTTER, RIGHT, columnsOf, confidencePlot, evidencePlot } from "../draw/plots.js";
import { fixed, seconds } from "../format.js";
import { RecordingBar } from "../replay.jsx";
import { limits, store } from "../robot.js";
import { set, settings } from "../settings.js";
import { missingOf } from "../store.js";
import { theme } from "../theme.js";
import { changedByUser, onChange, useChanges } from "../ticker.js";

const SPANS = [
  [15, "15 s"],
  [60, "1 min"],
  [300, "5 min"],
  [600, "10 min"],
];
const NEAR = 7; // pixels from a mark
const LEAST = 10; // s, the shortest time axis while there is less data
const DRAG = 4; // pixels after which a press is a drag

/// end: s of the right edge; pointer: its position from 0 to 1 along the axis, or null; width: pixels of the axis.
const view = { end: null, pointer: null, width: 1 };

function range() {
  if (store.isLive || view.end === null) view.end = store.newest;
  if (!store.isLive) {
    // The shown instant stays inside.
    if (store.instant > view.end) view.end = store.instant;
    if (store.instant < view.end - settings.span) view.end = store.instant + 0.9 * settings.span;
  }
  // The first minute fills the axis, too.
  const oldest = store.frames[0]?.time ?? 0;
  const from = Math.max(view.end - settings.span, Math.min(oldest, view.end - LEAST));
  return from < 0 && oldest >= 0 ? [0, Math.max(view.end, LEAST)] : [from, view.end]; // a robot starts at 0 s
}

/// The time below the pointer, or null.
function hovered() {
  if (view.pointer === null) return null;
  const [from, to] = range();
  return from + view.pointer * (to - from);
}

/// The machines whose states are shown: the chosen behaviors that run, or the first two, and the scenario.
function machines() {
  const chosen = settings.machines.filter((name) => store.bands.has(name));
  const isBehavior = (name) => name !== "status" && !store.scenario.has(name);
  const behaviors = chosen.length ? chosen : [...store.bands.keys()].filter(isBehavior).slice(0, 2);
  return settings.scenario ? [...behaviors, ...store.scenario] : behaviors;
}

function Readout() {
  useChanges(100);
  const hover = hovered();
  const time = hover ?? store.shown()?.time;
  if (time === undefined) return <span class="readout">No data yet.</span>;
  const frame = store.frames[Math.max(0, store.indexAt(time))];
  const state = (name) => store.bands.get(name)?.findLast((entry) => entry.time <= time + 1e-6)?.value;
  const [from, to] = range();
  const mark =
    hover !== null && marksOf(store).findLast((it) => Math.abs(it.time - time) < (NEAR * (to - from)) / view.width);
  const missing = missingOf(frame);
  const parts = [
    ["", seconds(time)],
    ...(hover === null && !store.isLive && missing ? [["", missing]] : []),
    ["evidence", fixed(frame?.evidence, 1)],
    ["current", fixed(frame?.current, 2)],
    ["opposite", fixed(frame?.opposite, 2)],
    ["status", state("status") || "–"],
    ...machines().map((name) => [name.replaceAll("_", " "), state(name) || "–"]),
  ];
  return (
    <span class="readout">
      {mark ? (
        <>
          <span>
            <b>{seconds(mark.time)}</b>
          </span>
          <span>{mark.text}</span>
        </>
      ) : (
        parts.map(([name, value]) => (
          <span key={name + value}>
            {name} <b>{value}</b>
          </span>
        ))
      )}
    </span>
  );
}

/// The cursor and the shown instant above all tracks.
function drawCursor(context, width, height) {
  const [from, to] = range();
  view.width = width - GUTTER - RIGHT;
  const x = (time) => GUTTER + ((time - from) / (to - from)) * view.width;
  const line = (time, color, thickness) => {
    if (time < from || time > to) return;
    context.fillStyle = color;
    context.fillRect(x(time) - thickness / 2, 0, thickness, height);
  };
  for (const event of store.events)
    if (event.kind === "command" && event.granted && isReorientation(event))
      line(event.time, themeColor("good-soft"), 1);
  const hover = hovered();
  if (hover !== null) line(hover, themeColor("soft"), 1);
  if (!store.isLive) {
    line(store.instant, themeColor("ink"), 2);
    if (store.instant < from || store.instant > to) return;
    context.beginPath();
    context.moveTo(x(store.instant) - 6, 0);
    context.lineTo(x(store.instant) + 6, 0);
    context.lineTo(x(store.instant), 8);
    context.fillStyle = themeColor("ink");
    context.fill();
  }
}

function follow(event) {
  const box = event.currentTarget.getBoundingClientRect();
  const fraction = (event.clientX - box.left - GUTTER) / (box.width - GUTTER - RIGHT);
  view.pointer = Math.min(1, Math.max(0, fraction));
  changedByUser();
}

/// A mark near a time, so that a click on it shows its exact frame.
function snapped(time) {
  const [from, to] = range();
  const reach = (NEAR * (to - from)) / Math.max(1, view.width);
  let best = null;
  for (const mark of marksOf(store))
    if (Math.abs(mark.time - time) < reach && (!best || Math.abs(mark.time - time) < Math.abs(best.time - time)))
      best = mark;
  return best ? best.time : time;
}

function usePointer() {
  const press = useRef(null);
  return {
    onPointerDown(event) {
      if (!store.frames.length) return;
      event.currentTarget.setPointerCapture(event.pointerId);
      press.current = { x: event.clientX, dragged: false };
    },
    onPointerMove(event) {
      follow(event);
      const start = press.current;
      if (start && (start.dragged || Math.abs(event.clientX - start.x) > DRAG)) {
        start.dragged = true;
        store.show(hovered()); // a drag moves the shown instant
      }
    },
    onPointerUp(event) {
      follow(event);
      if (press.current && !press.current.dragged) store.show(snapped(hovered()));
      if (event.pointerType === "touch") view.pointer = null;
      press.current = null;
    },
    onPointerCancel() {
      press.current = null;
    },
    onPointerLeave() {
      view.pointer = null;
      changedByUser();
    },
    onWheel(event) {
      event.preventDefault();
      if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
        const amount = ((event.deltaX || event.deltaY) / Math.max(1, view.width)) * settings.span;
        store.hold();
        view.end = Math.min(store.newest, view.end + amount);
        changedByUser();
        return;
      }
      follow(event);
      const at = hovered();
      const [from, to] = range();
      const span = Math.min(600, Math.max(3, settings.span * Math.exp(event.deltaY / 500)));
      if (!store.isLive)
        view.end = Math.min(Math.max(store.newest, store.instant), at + ((to - at) * span) / (to - from));
      set({ span });
    },
  };
}

function Plots({ bands }) {
  const box = useRef(null);
  useEffect(() => {
    const element = box.current;
    let plots = [];
    let made = "";
    const make = () => {
      const { clientWidth: width, clientHeight: height } = element;
      const key = `${width} ${height} ${theme.version}`;
      if (key === made || width < 150 || height < 50) return;
      made = key;
      for (const plot of plots) plot.destroy();
      const upper = Math.round(0.58 * height);
      plots = [
        evidencePlot(element, width, upper, range, limits),
        confidencePlot(element, width, height - upper, range),
      ];
    };
    const draw = () => {
      make();
      if (!plots.length) return;
      const [from, to] = range();
      const { evidence, confidence } = columnsOf(store, from, to);
      plots[0].setData(evidence);
      plots[1].setData(confidence);
    };
    const observer = new ResizeObserver(draw);
    observer.observe(element);
    const end = onChange(100, draw);
    return () => {
      observer.disconnect();
      end();
      for (const plot of plots) plot.destroy();
    };
  }, []);
  return <div class="plots" ref={box} style={{ bottom: `${bands}px` }} />;
}

function Timeline() {
  useChanges(500);
  const pointer = usePointer();
  const tracks = useRef(null);
  useEffect(() => {
    // A listener of preact is passive and cannot prevent that the page scrolls.
    const element = tracks.current;
    const wheel = (event) => pointer.onWheel(event);
    element.addEventListener("wheel", wheel, { passive: false });
    return () => element.removeEventListener("wheel", wheel);
  }, []);
  const bands = bandsHeight(machines());
  const { onWheel, ...handlers } = pointer;
  return (
    <div class="fill column timeline">
      <div class="row tight">
        <button
          class="button"
          id="pause"
          aria-pressed={!store.isLive}
          title="Space"
          onClick={() => store.toggleHold()}
        >
          {store.isLive ? "Pause view" : "Back to live"}
        </button>
        <span class="chips" role="group" aria-label="Length of the timeline">
          {SPANS.map(([span, name]) => (
            <button key={span} class="chip small" aria-pressed={settings.span === span} onClick={() => set({ span })}>
              {name}
            </button>
          ))}
        </span>
        <Readout />
      </div>
      <RecordingBar />
      <div class="tracks" ref={tracks} {...handlers}>
        <Plots bands={bands} />
        <div class="bands" style={{ height: `${bands}px` }}>
          <Canvas
            interval={100}
            label="States, commands, edits and notes over time"
            draw={(context, width) => drawBands(context, store, machines(), range(), width, theme.isDark)}
          />
        </div>
        <Canvas className="cursor" interval={33} label="Cursor of the timeline" draw={drawCursor} />
      </div>
    </div>
  );
}

export default { id: "timeline", title: "Timeline", area: "bottom", key: "9", Component: Timeline };
