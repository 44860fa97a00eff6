// SPDX-License-Identifier: MIT
// Where a state machine is drawn: nested boxes in layers, and arrows that leave boxes at the bottom and enter them at
// the top, or the other way round against the direction of the layers. Each level of nesting is laid out alone; an
// arrow that leaves a box has a port at its border. Plain numbers, in pixels.
import { orderLayers, placeNodes, rankNodes } from "./layers.js";
import { ANY, levelOf, treeOf } from "./tree.js";

const LINE = 15; // height of a line of a name
const PAD = 11; // around a name, and inside an outer state
const TITLE = 23; // of an outer state
const GAP = { x: 16, y: 40, port: 16 };
const END = 17; // of an arrow at a border
const WIDE_END = 32; // of one whose begin has several numbers
const WIDEST = 96; // of a line of a name
const LOOP = 22; // beside a box, of a transition to itself

/// A name in lines that are not wider than WIDEST, if it has spaces.
export function linesOf(name, measure) {
  const lines = [];
  for (const word of String(name).split(" ")) {
    const longer = lines.length ? `${lines.at(-1)} ${word}` : word;
    if (lines.length && measure(longer) <= WIDEST) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}

/// The place nearest to a wish that is not close to a taken one, and at most `most` from the center if possible.
function freeEnd(wish, taken, most) {
  const isFree = (x) => Math.abs(x) <= most && taken.every((other) => Math.abs(x - other) >= END - 3);
  for (let step = 0; step <= 2 * most; step += 2)
    for (const x of [wish - step, wish + step]) if (isFree(x)) return x;
  return Math.max(-most, Math.min(most, wish));
}

/// The width of an end of an edge at the border of its node.
function endOf({ link }, name) {
  const isBegin = (name === "upperAt") !== link.isReversed;
  return isBegin && link.arrow.transitions.length > 1 ? WIDE_END : END;
}

class Layout {
  constructor(definition, measure) {
    this.tree = treeOf(definition);
    this.measure = measure;
    this.links = this.tree.arrows.map((arrow) => ({ arrow, ...levelOf(arrow, this.tree), points: [] }));
    this.ranks = new Map(); // outer state: Map(inner state or "any": rank)
    for (let outer = 0; outer < this.tree.states.length; ++outer) this.ranks.set(outer, this.rank(outer));
    // The end of each link that is above, and the states that it leaves downwards or enters from above.
    for (const link of this.links) {
      link.isReversed = false;
      const ranks = this.ranks.get(link.outer);
      if (link.from !== null && link.to !== null) link.isReversed = ranks.get(link.from) > ranks.get(link.to);
      link.isLoop = link.arrow.from === link.arrow.to;
    }
  }

  rank(outer) {
    const { inner, states } = this.tree;
    const edges = this.links.filter((it) => it.outer === outer && it.from !== null && it.to !== null);
    const first = states[outer].initial;
    const nodes = [...inner[outer]].sort((a, b) => (b === first) - (a === first) || a - b);
    if (edges.some((it) => it.from === "any")) nodes.splice(1, 0, "any");
    return rankNodes(nodes, edges);
  }

  /// Whether a state is inside another one.
  isInside(state, outer) {
    return state !== outer && this.tree.chain(state).includes(outer);
  }

  /// The parts of links within an outer state: between two inner states, or from one to a port at the border.
  partsIn(outer) {
    const parts = [];
    const child = (state) => this.tree.chain(state)[this.tree.chain(outer).length];
    for (const link of this.links) {
      if (link.isLoop) continue;
      const { from, to } = link.arrow;
      // null: the border of this state.
      let ends = null;
      if (link.outer === outer) ends = [link.from, link.to];
      else if (!this.isInside(outer, link.outer)) continue;
      else if (from !== ANY && this.isInside(from, outer)) ends = [child(from), null];
      else if (this.isInside(to, outer)) ends = [null, child(to)];
      if (!ends) continue;
      const [upper, lower] = link.isReversed ? ends.reverse() : ends;
      parts.push({ link, upper, lower });
    }
    return parts;
  }

  /// The size of a state, and what is inside, with positions from its upper left corner.
  box(state) {
    const inside = state === "any" ? [] : this.tree.inner[state];
    const { name = "" } = this.tree.states[state] ?? {};
    if (inside.length) return this.outerBox(state, name);
    const lines = state === "any" ? ["any state"] : linesOf(name, this.measure);
    const textWidth = Math.max(...lines.map((line) => this.measure(line)));
    const isLoop = this.links.some((it) => it.isLoop && it.arrow.from === state);
    return { state, lines, boxes: [], loop: isLoop ? LOOP : 0, width: textWidth + 2 * PAD, height: lines.length * LINE + PAD };
  }

  outerBox(outer, name) {
    const parts = this.partsIn(outer);
    const ranks = this.ranks.get(outer);
    const isWhole = outer === ANY;
    const nodes = new Map();
    const last = Math.max(...ranks.values());
    const layers = Array.from({ length: last + 3 }, () => []); // the first and the last contain ports
    const add = (rank, node) => {
      Object.assign(node, { up: [], down: [], rank });
      layers[rank].push(node);
      return node;
    };
    for (const [state, rank] of ranks) {
      const box = this.box(state);
      nodes.set(state, add(rank + 1, { box, width: box.width + box.loop, weight: 1 }));
    }
    const chains = parts.map((part) => {
      const ends = [
        part.upper === null ? add(0, { width: 6, weight: 0.5, isPort: true }) : nodes.get(part.upper),
        part.lower === null ? add(last + 2, { width: 6, weight: 0.5, isPort: true }) : nodes.get(part.lower),
      ];
      const chain = [ends[0]];
      for (let rank = ends[0].rank + 1; rank < ends[1].rank; ++rank)
        chain.push(add(rank, { width: 8, weight: 6, isBend: true }));
      chain.push(ends[1]);
      const edges = chain.slice(1).map((lower, i) => ({ link: part.link, upper: chain[i], lower }));
      for (const edge of edges) {
        edge.upper.down.push(edge);
        edge.lower.up.push(edge);
      }
      return { link: part.link, chain, edges };
    });
    const ordered = orderLayers(layers);
    this.placeEnds(ordered);
    const upperAt = (edge) => edge.upperAt;
    const lowerAt = (edge) => edge.lowerAt;
    const leastWidth = isWhole ? 0 : Math.max(this.measure(name), this.endsAt(outer, parts)) + 2 * PAD;
    const innerWidth = placeNodes(ordered.filter((layer) => layer.length), GAP.x, upperAt, lowerAt);
    const width = Math.max(innerWidth + (isWhole ? 0 : 2 * PAD), leastWidth);
    const left = (width - innerWidth) / 2;
    const height = this.placeLayers(ordered, isWhole ? 0 : TITLE, last);
    const ports = new Map();
    const points = new Map(); // link: points, from the upper to the lower end
    for (const { link, chain, edges } of chains) {
      const path = [];
      chain.forEach((node, i) => {
        if (i > 0) {
          const x = left + node.x + edges[i - 1].lowerAt;
          path.push([x, node.top]);
          if (node.isPort) path.push([x, height]);
          else if (node.box) path.push([x, node.y]);
        }
        if (i === chain.length - 1) return;
        const x = left + node.x + edges[i].upperAt;
        if (node.isPort) path.push([x, 0]);
        else if (node.box) path.push([x, node.y + node.box.height]);
        path.push([x, node.bottom]);
      });
      points.set(link, [...(points.get(link) ?? []), ...path]);
      if (chain[0].isPort) ports.set(link, left + chain[0].x);
      if (chain.at(-1).isPort) ports.set(link, left + chain.at(-1).x);
    }
    const boxes = [...nodes.values()].map(({ box, x, y }) => ({ ...box, x: left + x - (box.width + box.loop) / 2, y }));
    const loop = this.links.some((it) => it.isLoop && it.arrow.from === outer) ? LOOP : 0;
    return { state: outer, lines: [name], boxes, loop, ports, points, width, height };
  }

  /// The width that arrows need at the busier border of an outer state: its own, and those that pass it (`parts`).
  endsAt(outer, parts) {
    const ends = { top: 0, bottom: 0 };
    for (const { link, upper, lower } of parts)
      if (link.outer !== outer) ends[upper === null ? "top" : lower === null ? "bottom" : "none"] += 2 * END;
    for (const { arrow, outer: level, isReversed, isLoop } of this.links) {
      if (isLoop || level === outer) continue;
      const width = arrow.transitions.length > 1 ? WIDE_END : END;
      if (arrow.from === outer) ends[isReversed ? "top" : "bottom"] += width;
      if (arrow.to === outer) ends[isReversed ? "bottom" : "top"] += width;
    }
    return Math.max(ends.top, ends.bottom);
  }

  /// Where edges end at the border of each node, from its center.
  placeEnds(layers) {
    const places = new Map(layers.flatMap((layer) => layer.map((node, i) => [node, i])));
    for (const node of layers.flat()) {
      for (const [edges, other, name] of [
        [node.down, "lower", "upperAt"],
        [node.up, "upper", "lowerAt"],
      ]) {
        edges.sort((a, b) => places.get(a[other]) - places.get(b[other]));
        const widths = edges.map((edge) => endOf(edge, name));
        const all = widths.reduce((sum, width) => sum + width, 0);
        if (node.box && !node.box.boxes.length) node.width = Math.max(node.width, all + node.box.loop);
        let next = -all / 2;
        const taken = []; // by arrows that come from the inside
        for (const edge of edges) {
          const port = node.box?.ports?.get(edge.link);
          if (port === undefined) continue;
          edge[name] = port - (node.box.width + node.box.loop) / 2;
          taken.push(edge[name]);
        }
        edges.forEach((edge, i) => {
          next += widths[i];
          if (node.box?.ports?.has(edge.link)) return;
          const wish = node.box ? next - widths[i] / 2 - node.box.loop / 2 : 0;
          edge[name] = taken.length ? freeEnd(wish, taken, node.box.width / 2 - PAD) : wish;
          if (taken.length) taken.push(edge[name]);
        });
      }
      if (node.box && !node.box.boxes.length) node.box.width = node.width - node.box.loop;
    }
  }

  /// Sets y of the nodes, and top and bottom of their layers. Returns the height.
  placeLayers(layers, top, last) {
    let y = top;
    const busiest = (layer) => Math.min(6, layer.reduce((sum, node) => sum + node.down.length, 0));
    layers.forEach((layer, rank) => {
      const isPorts = rank === 0 || rank === last + 2;
      if (isPorts) {
        if (layer.length && rank > 0) y += GAP.port;
        for (const node of layer) node.top = node.bottom = y;
        if (layer.length && rank === 0) y += GAP.port;
        return;
      }
      const height = Math.max(...layer.map((node) => node.box?.height ?? 0));
      for (const node of layer) {
        node.top = y;
        node.bottom = y + height;
        node.y = y + (height - (node.box?.height ?? 0)) / 2;
      }
      y += height + (rank === last + 1 ? 0 : GAP.y + 2 * busiest(layer));
    });
    return y + (top ? PAD : 0);
  }

  run() {
    if (!this.tree.inner[0]?.length) return { width: 0, height: 0, boxes: [], arrows: [] };
    const whole = this.box(0);
    const boxes = [];
    const collect = (box, x, y, depth) => {
      for (const [link, points] of box.points ?? [])
        for (const [px, py] of points) link.points.push([x + px, y + py]);
      for (const one of box.boxes) {
        const placed = { ...one, x: x + one.x, y: y + one.y, depth, isOuter: one.boxes.length > 0 };
        const { boxes: _, points: __, ports: ___, ...plain } = placed;
        boxes.push(plain);
        collect(one, placed.x, placed.y, depth + 1);
      }
    };
    collect(whole, 0, 0, 0);
    const arrows = this.links.map(({ arrow, points, isReversed, isLoop }) => {
      if (isLoop) return { ...arrow, isReversed: false, points: loopOf(boxes.find((it) => it.state === arrow.from)) };
      // Each part goes downwards, so the parts of all levels follow each other by y.
      const path = points.map((point, i) => ({ point, i })).sort((a, b) => a.point[1] - b.point[1] || a.i - b.i);
      return { ...arrow, isReversed, points: withoutRepeats(path.map((it) => it.point), isReversed) };
    });
    return { width: whole.width, height: whole.height, boxes, arrows };
  }
}

function loopOf(box) {
  const x = box.x + box.width;
  return [
    [x, box.y + box.height * 0.25],
    [x + LOOP - 4, box.y + box.height * 0.25],
    [x + LOOP - 4, box.y + box.height * 0.75],
    [x, box.y + box.height * 0.75],
  ];
}

function withoutRepeats(points, isReversed) {
  const rounded = points.map((point) => point.map((value) => Math.round(10 * value) / 10));
  const path = rounded.filter(([x, y], i) => i === 0 || x !== rounded[i - 1][0] || y !== rounded[i - 1][1]);
  return isReversed ? path.reverse() : path;
}

/// The drawing of a definition, as the service `machine` sends it: {width, height, boxes, arrows}. A box is {state,
/// lines, x, y, width, height, depth, isOuter}; state "any" stands for the machine's own transitions. An arrow is
/// {from, to, transitions, points, isReversed}: indexes of transitions with the same ends; reversed ones go up.
/// `measure(text)`: its width.
export const layoutOf = (definition, measure) => new Layout(definition, measure).run();
