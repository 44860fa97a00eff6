// SPDX-License-Identifier: MIT
// Layers of one level of a graph: which node is above which, their order in a layer that avoids crossings, and their
// positions. A node is {id, width, ...}; an edge is {upper, lower, ...} after rankNodes().

const SWEEPS = 8; // of the order of nodes
const PASSES = 24; // of their positions

/// Non-negative ranks, by the longest path. A search from each node in turn decides which end of an edge {from, to} is
/// above: the one that it reaches first. So edges that close a cycle, or return to an earlier node, go up. Returns
/// Map(node: rank).
export function rankNodes(nodes, edges) {
  const next = new Map(nodes.map((node) => [node, []]));
  for (const { from, to } of edges) next.get(from).push(to);
  const state = new Map(); // node: "open" while the search is below it, then the node where the search began
  const down = new Map(nodes.map((node) => [node, []])); // without cycles
  const order = []; // each node before those below it
  const visit = (root) => {
    const stack = [[root, 0]];
    const finished = [];
    state.set(root, "open");
    while (stack.length) {
      const top = stack.at(-1);
      const [node, index] = top;
      const target = next.get(node)[index];
      if (target === undefined) {
        state.set(node, root);
        finished.push(node);
        stack.pop();
        continue;
      }
      ++top[1];
      if (state.has(target) && state.get(target) !== root) {
        down.get(target).push(node); // an open one, or one of an earlier search
        continue;
      }
      down.get(node).push(target);
      if (!state.has(target)) {
        state.set(target, "open");
        stack.push([target, 0]);
      }
    }
    order.push(...finished.reverse());
  };
  for (const node of nodes) if (!state.has(node)) visit(node);
  const ranks = new Map(nodes.map((node) => [node, 0]));
  for (const node of order)
    for (const below of down.get(node)) ranks.set(below, Math.max(ranks.get(below), ranks.get(node) + 1));
  return ranks;
}

/// Crossings of the edges between two neighboring layers.
function crossings(layer, below) {
  const places = new Map(below.map((node, i) => [node, i]));
  const ends = layer.flatMap((node) => node.down.map((it) => places.get(it.lower)).sort((a, b) => a - b));
  let count = 0;
  for (let i = 0; i < ends.length; ++i) for (let j = i + 1; j < ends.length; ++j) if (ends[i] > ends[j]) ++count;
  return count;
}

const allCrossings = (layers) =>
  layers.slice(1).reduce((sum, layer, i) => sum + crossings(layers[i], layer), 0);

/// Orders the nodes of each layer by the mean place of their neighbors. Nodes know their edges: `up` and `down`.
export function orderLayers(layers) {
  let best = layers.map((layer) => [...layer]);
  let least = allCrossings(best);
  let current = best.map((layer) => [...layer]);
  for (let sweep = 0; sweep < SWEEPS && least > 0; ++sweep) {
    const isDown = sweep % 2 === 0;
    const indexes = current.map((_, i) => i);
    for (const i of isDown ? indexes : indexes.reverse()) {
      const places = new Map(current.flatMap((layer) => layer.map((node, place) => [node, place])));
      const wish = (node) => {
        const near = isDown ? node.up.map((it) => it.upper) : node.down.map((it) => it.lower);
        if (!near.length) return places.get(node);
        return near.reduce((sum, it) => sum + places.get(it), 0) / near.length;
      };
      const wishes = new Map(current[i].map((node) => [node, wish(node)]));
      current[i].sort((a, b) => wishes.get(a) - wishes.get(b) || places.get(a) - places.get(b));
    }
    const count = allCrossings(current);
    if (count < least) {
      least = count;
      best = current.map((layer) => [...layer]);
    }
  }
  return best;
}

/// Places nodes at least `gap` apart, as close to their wishes as possible: least squares, by pooling neighbors.
function placeLayer(layer, wishes, gap) {
  const offsets = [];
  let offset = 0;
  layer.forEach((node, i) => {
    if (i > 0) offset += (layer[i - 1].width + node.width) / 2 + gap;
    offsets.push(offset);
  });
  const pools = [];
  layer.forEach((node, i) => {
    pools.push({ sum: node.weight * (wishes[i] - offsets[i]), weight: node.weight, count: 1 });
    while (pools.length > 1) {
      const last = pools.at(-1);
      const before = pools.at(-2);
      if (before.sum / before.weight <= last.sum / last.weight) break;
      pools.splice(-2, 2, {
        sum: before.sum + last.sum,
        weight: before.weight + last.weight,
        count: before.count + last.count,
      });
    }
  });
  let i = 0;
  for (const { sum, weight, count } of pools)
    for (let k = 0; k < count; ++k, ++i) layer[i].x = sum / weight + offsets[i];
}

/// Sets `x`, the center of each node, with the smallest left edge at 0. `upperAt(edge)`, `lowerAt(edge)`: where an edge
/// ends, from the center of its node. Returns the width.
export function placeNodes(layers, gap, upperAt, lowerAt) {
  for (const layer of layers) {
    const width = layer.reduce((sum, node) => sum + node.width + gap, -gap);
    let x = -width / 2;
    for (const node of layer) {
      node.x = x + node.width / 2;
      x += node.width + gap;
    }
  }
  for (let pass = 0; pass < PASSES; ++pass) {
    const isDown = pass % 2 === 0;
    for (const layer of isDown ? layers : [...layers].reverse()) {
      const wishes = layer.map((node) => {
        const fromUp = node.up.map((edge) => edge.upper.x + upperAt(edge) - lowerAt(edge));
        const fromDown = node.down.map((edge) => edge.lower.x + lowerAt(edge) - upperAt(edge));
        let near = isDown ? fromUp : fromDown;
        if (pass >= PASSES - 4 || !near.length) near = [...fromUp, ...fromDown];
        return near.length ? near.reduce((sum, x) => sum + x, 0) / near.length : node.x;
      });
      placeLayer(layer, wishes, gap);
    }
  }
  const all = layers.flat();
  if (!all.length) return 0;
  const left = Math.min(...all.map((node) => node.x - node.width / 2));
  for (const node of all) node.x -= left;
  return Math.max(...all.map((node) => node.x + node.width / 2));
}
