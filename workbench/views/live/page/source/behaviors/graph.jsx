// SPDX-License-Identifier: MIT
// The states of a machine as nested boxes with arrows. The active states, the last transition, and the transitions of
// the shown state are marked.
import { useMemo } from "preact/hooks";

import { layoutOf } from "./layout.js";
import { pathText } from "./view.js";

const FONT = "12px system-ui, sans-serif";
const LINE = 15;
const MARGIN = 12;
const SMALLEST = 0.75; // scale below which the graph is scrolled
const HEAD = { width: 8, length: 8 };
const BADGE = 13; // from the begin of an arrow

const canvas = document.createElement("canvas").getContext("2d");
function measure(text) {
  canvas.font = FONT;
  return canvas.measureText(text).width * 1.04; // fonts of SVG and canvas may differ a little
}

/// A line that is vertical at its ends.
function pathOf({ points }) {
  return points
    .map(([x, y], i) => {
      if (i === 0) return `M${x} ${y}`;
      const [before, above] = points[i - 1];
      if (x === before || y === above) return `L${x} ${y}`;
      const middle = (above + y) / 2;
      return `C${before} ${middle} ${x} ${middle} ${x} ${y}`;
    })
    .join("");
}

function headOf({ points, isReversed, from, to }) {
  const [x, y] = points.at(-1);
  const [half, length] = [HEAD.width / 2, HEAD.length];
  if (from === to) return `M${x} ${y}l${length} ${-half}v${HEAD.width}z`;
  return `M${x} ${y}l${-half} ${isReversed ? length : -length}h${HEAD.width}z`;
}

/// Numbers of an arrow: "1", "1 3", "1–3".
function numbersText(numbers) {
  const isRun = numbers.length > 2 && numbers.at(-1) - numbers[0] === numbers.length - 1;
  return isRun ? `${numbers[0]}–${numbers.at(-1)}` : numbers.join(" ");
}

function Arrow({ arrow, numbers, isLast, title }) {
  const [x, y] = arrow.points[0];
  const isLoop = arrow.from === arrow.to;
  const text = numbersText(numbers);
  const place = isLoop ? [x + 9, y - 8] : [x, y + (arrow.isReversed ? -BADGE : BADGE)];
  const half = Math.max(7, 3.4 * text.length + 3);
  return (
    <g class={`arrow ${isLast ? "last" : ""} ${numbers.length ? "numbered" : ""}`}>
      <title>{title}</title>
      <path class="reach" d={pathOf(arrow)} />
      <path class="line" d={pathOf(arrow)} />
      <path class="head" d={headOf(arrow)} />
      {numbers.length > 0 && (
        <g transform={`translate(${place[0]} ${place[1]})`} class="number">
          <rect x={-half} y={-7} width={2 * half} height={14} rx={7} />
          <text y={3.5}>{text}</text>
        </g>
      )}
    </g>
  );
}

function State({ box, state, isActive, isChosen, isInitial, onChoose }) {
  const { x, y, width, height, lines, isOuter } = box;
  const isAny = box.state === "any";
  const press = (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    event.stopPropagation(); // Space pauses the view elsewhere
    onChoose(box.state);
  };
  const classes = ["box", isOuter && "outer", isActive && "active", isChosen && "chosen", isAny && "any"];
  const action = isAny
    ? {}
    : {
        role: "button",
        tabindex: 0, // in lower case, because SVG is case-sensitive
        "aria-pressed": isChosen,
        "aria-label": `${pathText(state.path)}${isActive ? ", active" : ""}`,
        onClick: () => onChoose(box.state),
        onKeyDown: press,
      };
  return (
    <g class={classes.filter(Boolean).join(" ")} {...action}>
      {isInitial && <circle class="initial" cx={x - 6} cy={y + 8} r={3.2} />}
      {isInitial && <path class="initial" d={`M${x - 6} ${y + 8}H${x}`} />}
      <rect x={x} y={y} width={width} height={height} rx={isAny ? height / 2 : 6} />
      {isOuter ? (
        <text class="title" x={x + 9} y={y + 15}>
          {lines[0]}
        </text>
      ) : (
        lines.map((line, i) => (
          <text key={i} x={x + width / 2} y={y + height / 2 + LINE * (i - (lines.length - 1) / 2) + 4}>
            {line}
          </text>
        ))
      )}
    </g>
  );
}

/// definition: of the machine; active: path of its state; chosen: index of the state whose transitions are listed;
/// numbers: Map(index of a transition: number in the list); last: index of the last transition; onChoose(state).
export function StateGraph({ definition, active, chosen, numbers, last, onChoose }) {
  const graph = useMemo(() => layoutOf(definition, measure), [definition]);
  const { states, transitions } = definition;
  if (!graph.boxes.length) return <p class="empty">This behavior has no states.</p>;
  const width = graph.width + 2 * MARGIN;
  const height = graph.height + 2 * MARGIN;
  const isActive = (state) => state !== "any" && (active === states[state].path || active.startsWith(`${states[state].path}/`));
  const isInitial = (state) => state !== "any" && states[states[state].outer]?.initial === state;
  const reasonOf = (index) => transitions[index].reason;
  const titleOf = ({ from, to, transitions: all }) =>
    `${from === 0 ? "any state" : pathText(states[from].path)} → ${pathText(states[to].path)}: ${all.map(reasonOf).join("; ")}`;
  return (
    <div class="graph">
      <svg
        viewBox={`${-MARGIN} ${-MARGIN} ${width} ${height}`}
        style={{ width: `${width}px`, minWidth: `${Math.round(SMALLEST * width)}px` }}
        aria-label={`States of ${definition.name}`}
      >
        {graph.boxes.map((box) => (
          <State
            key={box.state}
            box={box}
            state={states[box.state]}
            isActive={isActive(box.state)}
            isChosen={box.state === chosen}
            isInitial={isInitial(box.state)}
            onChoose={onChoose}
          />
        ))}
        {graph.arrows.map((arrow) => (
          <Arrow
            key={`${arrow.from} ${arrow.to}`}
            arrow={arrow}
            numbers={arrow.transitions.flatMap((index) => numbers.get(index) ?? [])}
            isLast={arrow.transitions.includes(last)}
            title={titleOf(arrow)}
          />
        ))}
      </svg>
      <p class="graph-legend">
        <i class="is-active" /> active <i class="is-last" /> last transition <i class="is-number">1</i> in the list
      </p>
    </div>
  );
}
