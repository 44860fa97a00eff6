// SPDX-License-Identifier: MIT
// live_viewers.mjs PROGRAM VIEWERS STALLED SECONDS WIDTH: runs the simulator for SECONDS in real time with images of
// WIDTH pixels. VIEWERS receive all topics; STALLED of them read nothing. Prints the times of a frame, the memory of the
// program, and the time that a what-if takes. Compare with a run of 0 viewers.
import { spawn } from "node:child_process";
import { randomBytes } from "node:crypto";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { connect } from "node:net";
import { setPriority, tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";

const [program, viewers, stalled, seconds, width] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "live-viewers-"));
const summary = join(folder, "summary.json");
const run = spawn(
  program,
  ["--log", "off", "run", "patrol", "--live", "0", "--width", width, "--seconds", seconds, "--no-pictures", "--json", summary],
  { stdio: ["ignore", "ignore", "pipe"] },
);
setPriority(19); // viewers are other computers
const ended = new Promise((resolve) => run.on("exit", resolve));
const link = await new Promise((resolve, reject) => {
  createInterface(run.stderr).on("line", (line) => {
    const found = line.match(/live view: (\S+)/);
    if (found) resolve(new URL(found[1]));
  });
  ended.then((code) => reject(new Error(`expected a link, found the exit code ${code}`)));
});

/// A message of a client, with a mask of zeros.
function frame(opcode, payload) {
  const head = Buffer.alloc(payload.length < 126 ? 6 : 8);
  head[0] = 0x80 | opcode;
  head[1] = 0x80 | (payload.length < 126 ? payload.length : 126);
  if (payload.length >= 126) head.writeUInt16BE(payload.length, 2);
  return Buffer.concat([head, payload]);
}

/// Calls `take(opcode, payload)` for each message of the server.
function readFrames(socket, take) {
  let bytes = Buffer.alloc(0);
  socket.on("data", (more) => {
    bytes = Buffer.concat([bytes, more]);
    while (bytes.length >= 2) {
      const short = bytes[1] & 127;
      const begin = short < 126 ? 2 : short === 126 ? 4 : 10;
      if (bytes.length < begin) return;
      const size = short < 126 ? short : short === 126 ? bytes.readUInt16BE(2) : Number(bytes.readBigUInt64BE(2));
      if (bytes.length < begin + size) return;
      take(bytes[0] & 15, bytes.subarray(begin, begin + size));
      bytes = bytes.subarray(begin + size);
    }
  });
}

/// A socket after the handshake.
async function open() {
  const socket = connect(Number(link.port), link.hostname);
  socket.on("error", () => {}); // the run ends first
  socket.write(
    `GET ${link.pathname}${link.search} HTTP/1.1\r\nHost: ${link.host}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n` +
      `Sec-WebSocket-Key: ${randomBytes(16).toString("base64")}\r\nSec-WebSocket-Version: 13\r\n` +
      "Sec-WebSocket-Protocol: foxglove.websocket.v1\r\n\r\n",
  );
  let head = Buffer.alloc(0);
  while (!head.includes("\r\n\r\n"))
    head = Buffer.concat([head, await new Promise((resolve) => socket.once("data", resolve))]);
  socket.pause();
  socket.unshift(head.subarray(head.indexOf("\r\n\r\n") + 4));
  return socket;
}

let received = 0;
async function watch(isStalled) {
  const socket = await open();
  readFrames(socket, (opcode, payload) => {
    received += payload.length;
    if (opcode !== 1) return;
    const message = JSON.parse(payload);
    if (message.op !== "advertise") return;
    const subscriptions = message.channels.map(({ id }) => ({ id, channelId: id }));
    socket.write(frame(1, Buffer.from(JSON.stringify({ op: "subscribe", subscriptions }))));
    if (isStalled) socket.pause();
  });
  socket.resume();
}

/// The answer to a what-if on the last 30 s, and the ms that it took.
async function ask() {
  const socket = await open();
  const begin = performance.now();
  const answer = await new Promise((resolve) => {
    readFrames(socket, (opcode, payload) => {
      if (opcode === 2 && payload[0] === 3) resolve(JSON.parse(payload.subarray(13 + payload.readUInt32LE(9))));
      if (opcode !== 1) return;
      const message = JSON.parse(payload);
      if (message.op === "serviceCallFailure") resolve({ failure: message.message });
      if (message.op !== "advertiseServices") return;
      const { id } = message.services.find(({ name }) => name === "what_if");
      const call = Buffer.alloc(17);
      call[0] = 2;
      call.writeUInt32LE(id, 1);
      call.writeUInt32LE(4, 9);
      call.write("json", 13);
      const change = { parameters: [{ name: "orientation.hold_time", value: 2 }], seconds: 30 };
      socket.write(frame(2, Buffer.concat([call, Buffer.from(JSON.stringify(change))])));
    });
    socket.resume();
  });
  socket.destroy();
  return { answer, milliseconds: Math.round(performance.now() - begin) };
}

const memory = () => Math.round(Number(readFileSync(`/proc/${run.pid}/status`, "utf8").match(/VmRSS:\s+(\d+)/)[1]) / 1024);
for (let i = 0; i < Number(viewers); ++i) watch(i < Number(stalled));
const begun = Date.now();
const whatIfs = [];
const sizes = [];
const interval = Math.max(1000, (1000 * Number(seconds)) / 10);
const timer = setInterval(async () => {
  try {
    sizes.push(`${Math.round((Date.now() - begun) / 1000)} s: ${memory()} MB`);
    if (Number(viewers) === 0) return;
    const { answer, milliseconds } = await ask();
    whatIfs.push(answer.failure ?? `${answer.frames} frames in ${milliseconds} ms`);
  } catch {
    // the run has ended
  }
}, interval);
await ended;
clearInterval(timer);
const { frame_time_milliseconds: whole, frame_time_without_rendering_milliseconds: own, frames } = JSON.parse(
  readFileSync(summary, "utf8"),
);
rmSync(folder, { recursive: true });
const text = ({ median, percentile_99: most, longest }) =>
  `median ${median.toFixed(2)}, 99 % within ${most.toFixed(2)}, longest ${longest.toFixed(2)} ms`;
console.log(`${viewers} viewers, ${stalled} of them stalled, ${frames} frames, ${Math.round(received / 1e6)} MB received`);
console.log(`a frame: ${text(whole)}`);
console.log(`without rendering: ${text(own)}`);
console.log(`memory: ${sizes.join(", ")}`);
console.log(`what-if: ${whatIfs.join(", ")}`);
process.exit(frames > 0 ? 0 : 1);
