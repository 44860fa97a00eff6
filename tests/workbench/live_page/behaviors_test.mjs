// SPDX-License-Identifier: MIT
// The panel of the behaviors without a browser: the layout of state graphs, and what is joined from the messages.
import assert from "node:assert/strict";
import { test } from "node:test";

import { layoutOf, linesOf } from "../../../workbench/views/live/page/source/behaviors/layout.js";
import {
  declaredTransitions,
  faultOf,
  isWithin,
  meanCosts,
  openTransitions,
  transitionOf,
} from "../../../workbench/views/live/page/source/behaviors/view.js";

const measure = (text) => 6.5 * text.length;
const CLOSE = 0.11; // positions are rounded to 0.1

/// A definition from paths and [from, to] pairs of paths; "" is the machine itself.
function definitionOf(paths, pairs, initial = {}) {
  const all = ["", ...paths];
  const index = (path) => all.indexOf(path);
  const outerOf = (path) => (path === "" ? -1 : index(path.includes("/") ? path.slice(0, path.lastIndexOf("/")) : ""));
  const states = all.map((path) => {
    const first = all.findIndex((other) => other !== "" && outerOf(other) === index(path));
    return { path, name: path.split("/").at(-1), outer: outerOf(path), initial: initial[path] ?? first };
  });
  const transitions = pairs.map(([from, to, reason = "why"], i) => ({
    from: index(from),
    to: index(to),
    reason,
    line: i + 1,
    file: "behaviors/b.lua",
    lasting: "",
    after: "",
    reads: [],
  }));
  return { name: "b", states, transitions };
}

const NESTED = definitionOf(
  ["watching", "watching/unconfirmed", "watching/confirmed", "correcting", "purging", "fallen", "lifted"],
  [
    ["", "lifted"],
    ["", "fallen"],
    ["watching", "purging"],
    ["watching/unconfirmed", "correcting"],
    ["watching/unconfirmed", "watching/confirmed"],
    ["watching/confirmed", "correcting"],
    ["watching/confirmed", "watching/unconfirmed"],
    ["correcting", "purging"],
    ["correcting", "watching"],
    ["purging", "watching/confirmed"],
    ["purging", "purging"],
    ["watching", "watching/confirmed"],
    ["watching/confirmed", "watching"],
    ["fallen", "watching"],
    ["lifted", "watching"],
  ],
);

function random(seed) {
  let state = seed;
  return (most) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * most);
  };
}

/// A machine of some states at random places.
function randomDefinition(seed, count, transitions) {
  const pick = random(seed);
  const paths = [];
  for (let i = 0; i < count; ++i) {
    const outer = i > 0 && pick(3) === 0 ? paths[pick(i)] : "";
    paths.push(outer && outer.split("/").length < 4 ? `${outer}/state ${i}` : `state ${i}`);
  }
  // Parents before children, as the robot sends them.
  const pairs = Array.from({ length: transitions }, () => [
    pick(8) === 0 ? "" : paths[pick(count)],
    paths[pick(count)],
  ]);
  return definitionOf(paths, pairs);
}

function checkLayout(definition) {
  const graph = layoutOf(definition, measure);
  const { states } = definition;
  const byState = new Map(graph.boxes.map((box) => [box.state, box]));
  assert.equal(graph.boxes.filter(({ state }) => state !== "any").length, states.length - 1);
  for (const box of graph.boxes) {
    for (const value of [box.x, box.y, box.width, box.height]) assert.ok(Number.isFinite(value));
    const outer = byState.get(states[box.state]?.outer);
    const [left, top, right, bottom] = outer
      ? [outer.x, outer.y, outer.x + outer.width, outer.y + outer.height]
      : [0, 0, graph.width, graph.height];
    assert.ok(box.x >= left - CLOSE && box.x + box.width <= right + CLOSE, `${states[box.state]?.path} is not inside`);
    assert.ok(box.y >= top - CLOSE && box.y + box.height <= bottom + CLOSE, `${states[box.state]?.path} is not inside`);
  }
  for (const a of graph.boxes)
    for (const b of graph.boxes) {
      if (a === b || states[a.state]?.outer !== states[b.state]?.outer) continue;
      const apart =
        a.x + a.width <= b.x + CLOSE ||
        b.x + b.width <= a.x + CLOSE ||
        a.y + a.height <= b.y + CLOSE ||
        b.y + b.height <= a.y + CLOSE;
      assert.ok(apart, `${states[a.state]?.path} and ${states[b.state]?.path} overlap`);
    }
  for (const arrow of graph.arrows) {
    const ends = [arrow.points[0], arrow.points.at(-1)];
    const boxes = [byState.get(arrow.from === 0 ? "any" : arrow.from), byState.get(arrow.to)];
    ends.forEach(([x, y], i) => {
      const { x: left, y: top, width, height } = boxes[i];
      const isAtBorder =
        Math.abs(y - top) < CLOSE || Math.abs(y - top - height) < CLOSE || Math.abs(x - left - width) < CLOSE;
      assert.ok(isAtBorder, `an arrow ends at ${x}, ${y}, not at the border of its state`);
      assert.ok(x >= left - CLOSE && x <= left + width + CLOSE, `an arrow ends beside its state, at ${x}`);
    });
    for (const [x, y] of arrow.points) {
      assert.ok(Number.isFinite(x) && Number.isFinite(y));
      assert.ok(x >= -CLOSE && x <= graph.width + CLOSE && y >= -CLOSE && y <= graph.height + CLOSE);
    }
  }
  return graph;
}

/// Whether a vertical line of an arrow passes through a state without inner states, which is not one of its ends.
function passesThrough(graph, arrow) {
  return graph.boxes.some((box) => {
    if (box.isOuter || box.state === arrow.from || box.state === arrow.to || (arrow.from === 0 && box.state === "any"))
      return false;
    return arrow.points.slice(1).some(([x, y], i) => {
      const [before, above] = arrow.points[i];
      if (before !== x) return false;
      const [top, bottom] = [Math.min(above, y), Math.max(above, y)];
      return x > box.x + CLOSE && x < box.x + box.width - CLOSE && bottom > box.y + CLOSE && top < box.y + box.height - CLOSE;
    });
  });
}

test("nested states are inside their outer state, and arrows connect borders", () => {
  const graph = checkLayout(NESTED);
  assert.equal(graph.arrows.length, NESTED.transitions.length);
  assert.deepEqual(graph.arrows.filter((arrow) => passesThrough(graph, arrow)), []);
});

test("the initial state and any state are at the top", () => {
  const { boxes } = layoutOf(NESTED, measure);
  const top = (state) => boxes.find((box) => box.state === state).y;
  for (const state of [4, 5, 6, 7]) assert.ok(top(1) < top(state) && top("any") < top(state));
  assert.ok(top(2) < top(3));
});

test("transitions with the same ends are one arrow", () => {
  const { arrows } = layoutOf(definitionOf(["a", "b"], [["a", "b"], ["b", "a"], ["a", "b"]]), measure);
  assert.deepEqual(arrows.map((arrow) => arrow.transitions), [[0, 2], [1]]);
  assert.deepEqual(arrows.map((arrow) => arrow.isReversed), [false, true]);
});

test("machines with no state, one state and forty states have a layout", () => {
  assert.deepEqual(layoutOf(definitionOf([], []), measure).boxes, []);
  assert.equal(checkLayout(definitionOf(["only"], [])).boxes.length, 1);
  assert.equal(checkLayout(definitionOf(["only"], [["only", "only"]])).arrows.length, 1);
  const names = Array.from({ length: 40 }, (_, i) => `state ${i}`);
  const chain = names.map((name, i) => [name, names[(i + 1) % 40]]);
  assert.equal(checkLayout(definitionOf(names, chain)).boxes.length, 40);
  const star = names.slice(1).flatMap((name) => [[names[0], name], [name, names[0]]]);
  assert.equal(checkLayout(definitionOf(names, star)).arrows.length, 78);
});

test("random machines have a layout, and no arrow passes through a state", () => {
  for (let seed = 1; seed <= 200; ++seed) {
    const graph = checkLayout(randomDefinition(seed, 1 + (seed % 40), seed % 60));
    assert.deepEqual(graph.arrows.filter((arrow) => passesThrough(graph, arrow)), [], `seed ${seed}`);
  }
});

test("damaged definitions give what is left of them", () => {
  assert.deepEqual(layoutOf({}, measure).boxes, []);
  const damaged = definitionOf(["a", "b"], [["a", "b"]]);
  damaged.transitions.push({ from: 7, to: 1 }, { from: -1, to: 1 }, { from: 1, to: 0 }, { from: "a", to: null });
  damaged.states.push({ path: "c", name: "c", outer: 99 }, { path: "d", name: null, outer: 4 });
  assert.equal(layoutOf(damaged, measure).arrows.length, 1);
  assert.equal(layoutOf(damaged, measure).boxes.length, 4);
});

test("a large machine is laid out in a second", () => {
  const begin = performance.now();
  layoutOf(randomDefinition(7, 120, 300), measure);
  assert.ok(performance.now() - begin < 20_000); // generous, for a slow machine
});

test("long names are broken at spaces only", () => {
  assert.deepEqual(linesOf("with any orientation", measure), ["with any", "orientation"]);
  assert.deepEqual(linesOf("a_name_without_any_space_at_all", measure), ["a_name_without_any_space_at_all"]);
});

test("open transitions are those of the machine, with the names that they read", () => {
  const definition = definitionOf(["a", "b"], [["", "b", "far"], ["a", "b", "near"], ["a", "b", "near"]]);
  definition.transitions[1].reads = ["pose.x"];
  definition.transitions[2].line = 2; // the same line
  const condition = { machine: "b", from: "a", target: "b", reason: "near", line: 2, when: "yes" };
  const rows = openTransitions(
    [condition, { ...condition, machine: "other" }, condition, { ...condition, line: 9 }],
    "b",
    definition,
  );
  assert.deepEqual(rows.map((row) => row.index), [1, 2, -1]);
  assert.deepEqual(rows[0].reads, ["pose.x"]);
  assert.equal(rows[2].file, "");
  assert.equal(openTransitions([condition], "b", null)[0].index, -1);
});

test("the transitions of a state contain those of the states around it, outer ones first", () => {
  const rows = declaredTransitions(NESTED, 3);
  assert.deepEqual(
    rows.map((row) => [row.from, row.target]),
    [
      ["", "lifted"],
      ["", "fallen"],
      ["watching", "purging"],
      ["watching", "watching/confirmed"],
      ["watching/confirmed", "correcting"],
      ["watching/confirmed", "watching/unconfirmed"],
      ["watching/confirmed", "watching"],
    ],
  );
});

test("an event is a transition of an outer state to the initial inner state, too", () => {
  const event = { kind: "transition", from: "lifted", to: "watching/unconfirmed", reason: "why" };
  assert.equal(transitionOf(NESTED, event), 14);
  assert.equal(transitionOf(NESTED, { ...event, from: "", to: "watching/unconfirmed", reason: "start" }), -1);
  assert.equal(transitionOf(NESTED, undefined), -1);
  assert.ok(isWithin("a/b", "a") && isWithin("a", "") && !isWithin("ab", "a"));
});

test("costs are means over frames, with their share of the frame", () => {
  const message = (microseconds, whole) => ({
    frame_milliseconds: whole,
    machines: [{ name: "a", microseconds, memory: 2048 }],
  });
  const { microseconds, share, memory } = meanCosts([message(10, 1), message(30, 3)]).get("a");
  assert.equal(microseconds, 20);
  assert.ok(Math.abs(share - 0.01) < 1e-9);
  assert.equal(memory, 2048);
  assert.equal(meanCosts([message(10, 0)]).get("a").share, 0);
  assert.equal(meanCosts([]).size, 0);
});

test("the last fault before an instant is that of the machine's file", () => {
  const log = [
    { time: 1, level: 4, name: "note", file: "behaviors/a.lua", line: 3 },
    { time: 2, level: 2, name: "a", file: "" },
    { time: 3, level: 4, name: "note", file: "behaviors/b.lua", line: 4 },
    { time: 5, level: 4, name: "note", file: "behaviors/a.lua", line: 5 },
  ];
  assert.equal(faultOf(log, "a", 4).line, 3);
  assert.equal(faultOf(log, "a", 5).line, 5);
  assert.equal(faultOf(log, "c", 9), null);
});
