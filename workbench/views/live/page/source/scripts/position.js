// SPDX-License-Identifier: MIT
// Columns of the robot count bytes of UTF-8 from 1; those of the editor count units of UTF-16 from 0.

const bytesOf = (character) => {
  const code = character.codePointAt(0);
  return code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
};

/// The word at a column of a line: {from, to}. Column 0 is the whole line.
export function rangeOf(line, column) {
  if (!column) return { from: 0, to: line.length };
  let from = 0;
  let bytes = 1;
  for (const character of line) {
    if (bytes >= column) break;
    bytes += bytesOf(character);
    from += character.length;
  }
  const word = /^[A-Za-z_0-9]+/.exec(line.slice(from))?.[0].length ?? 1;
  return { from, to: Math.min(line.length, from + word) };
}
