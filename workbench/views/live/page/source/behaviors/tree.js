// SPDX-License-Identifier: MIT
// The states of a machine as a tree, and which of its levels an arrow belongs to.

export const ANY = 0; // state 0 is the machine itself; its transitions leave any state

/// The definition with what is needed of it checked: hostile or damaged ones become a graph of what is left.
export function treeOf({ states = [], transitions = [] }) {
  const outerOf = states.map(({ outer }, i) => (i > 0 && outer >= 0 && outer < i ? outer : i > 0 ? 0 : -1));
  const inner = states.map((_, i) => outerOf.flatMap((outer, k) => (outer === i ? [k] : [])));
  const chain = (i) => {
    const all = [];
    for (let at = i; at >= 0; at = outerOf[at]) all.unshift(at);
    return all; // from the machine itself to the state
  };
  const exists = (i) => Number.isInteger(i) && i >= 0 && i < states.length;
  const arrows = new Map(); // transitions with the same ends are one arrow
  transitions.forEach(({ from, to }, index) => {
    if (!exists(from) || !exists(to) || to === ANY) return;
    const key = `${from} ${to}`;
    if (!arrows.has(key)) arrows.set(key, { from, to, transitions: [] });
    arrows.get(key).transitions.push(index);
  });
  return { states, inner, chain, arrows: [...arrows.values()] };
}

/// The level of an arrow: the outer state whose inner states it connects, and these two. The machine's own
/// transitions leave the node "any". null for an end: the border of the outer state itself.
export function levelOf(arrow, tree) {
  const from = tree.chain(arrow.from);
  const to = tree.chain(arrow.to);
  if (arrow.from === ANY) return { outer: 0, from: "any", to: to[1] };
  let depth = 0;
  while (depth < from.length && depth < to.length && from[depth] === to[depth]) ++depth;
  return { outer: from[depth - 1], from: from[depth] ?? null, to: to[depth] ?? null };
}
