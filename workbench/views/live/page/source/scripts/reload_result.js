// SPDX-License-Identifier: MIT
// What became of a saved script, from the log of the run.

const ACCEPTED = "the edit is running";
const REJECTED = "edit rejected; keeping the previous version: ";
const ERROR = 4; // level of the log

/// Whether a line of the log says that an edit is running.
export const isAccepted = ({ message }) => message === ACCEPTED;

/// A fault as a finding of its file: {file, line, column, severity, message}.
export function findingOf(text, file = "", line = 0) {
  const match = /^(\S+?\.lua):(\d+)(?::(\d+))?: (.*)$/s.exec(text);
  if (!match) return { file, line, column: 0, severity: "error", message: text };
  const [, inText, lineInText, column, message] = match;
  return { file: inText, line: Number(lineInText), column: Number(column ?? 0), severity: "error", message };
}

/// The last result of a file's reload at or after a time of the robot: {time, accepted, finding}, or null. A library is
/// reloaded with the scripts that require it, so their lines count, too.
export function reloadResult(log, file, since) {
  for (let i = log.length - 1; i >= 0 && log[i].time >= since; --i) {
    const { time, level, name, message, file: faulty, line } = log[i];
    const isAbout = name === file || faulty === file || file.startsWith("lib/");
    if (!isAbout || typeof message !== "string") continue;
    if (message === ACCEPTED) return { time, accepted: true, finding: null };
    if (message.startsWith(REJECTED))
      return { time, accepted: false, finding: findingOf(message.slice(REJECTED.length), faulty, line) };
    if (level >= ERROR && faulty === file)
      return { time, accepted: false, finding: findingOf(message, faulty, line) };
  }
  return null;
}
