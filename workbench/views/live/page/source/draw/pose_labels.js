// SPDX-License-Identifier: MIT
// Where the labels of poses are: marks that coincide share a label, and no label leaves the drawing or covers another
// mark.

const INK = "#535b65"; // of what joins the names

const overlap = (some, other) =>
  some.left < other.left + other.wide &&
  other.left < some.left + some.wide &&
  some.top < other.top + other.tall &&
  other.top < some.top + some.tall;

const boxOf = ({ u, v, reach }) => ({ left: u - reach, top: v - reach, wide: 2 * reach, tall: 2 * reach });

/// Marks that overlap, as one group: {u, v, reach, marks}.
function groupsOf(marks) {
  const groups = [];
  for (const mark of marks) {
    const near = groups.find(({ u, v, reach }) => Math.hypot(u - mark.u, v - mark.v) < Math.max(reach, mark.reach));
    if (near) {
      near.marks.push(mark);
      near.reach = Math.max(near.reach, mark.reach);
    } else groups.push({ u: mark.u, v: mark.v, reach: mark.reach, marks: [mark] });
  }
  return groups;
}

/// The boxes of the labels in pixels, [{left, top, wide, tall, parts: [{text, at, ink}]}]. `marks`: [{u, v, text, ink,
/// reach}], their middle and the radius that they need; `measure(text)`: its width; `font`: its height.
export function labelsOf(marks, measure, font, width, height) {
  const pad = 0.4 * font;
  const tall = 1.5 * font;
  const groups = groupsOf(marks);
  const placed = [];
  for (const group of groups) {
    const { u, v, reach } = group;
    const parts = [];
    let wide = pad;
    group.marks.forEach(({ text, ink }, i) => {
      for (const part of i ? [{ text: " + ", ink: INK }, { text, ink }] : [{ text, ink }]) {
        parts.push({ ...part, from: wide });
        wide += measure(part.text);
      }
    });
    wide += pad;
    const [middle, gap] = [u - wide / 2, 0.85 * reach];
    const positions = [
      [middle, v + gap + 2],
      [middle, v - gap - 2 - tall],
      [u + reach, v - tall / 2],
      [u - reach - wide, v - tall / 2],
    ].map(([left, top]) => ({
      left: Math.max(2, Math.min(left, width - wide - 2)),
      top: Math.max(2, Math.min(top, height - tall - 2)),
      wide,
      tall,
    }));
    const others = [...groups.filter((it) => it !== group).map(boxOf), ...placed];
    const core = boxOf({ u, v, reach: 0.6 * reach });
    const isFree = (box) => ![core, ...others].some((it) => overlap(box, it));
    const box = positions.find(isFree) ?? positions[0];
    placed.push({ ...box, parts: parts.map(({ text, ink, from }) => ({ text, ink, at: box.left + from })) });
  }
  return placed;
}
