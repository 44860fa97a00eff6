// SPDX-License-Identifier: MIT
// A stand-in for `reorient run --live`: serves the page and replays a recording over the Foxglove WebSocket protocol,
// with parameters and services. For the development and the tests of the page.
import { readFileSync, readdirSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";

import { load } from "../packages.mjs";

const { WebSocketServer } = load("ws");

const SUBPROTOCOL = "foxglove.websocket.v1";
const LASTING = new Set([
  "/field",
  "/wall",
  "/room",
  "/parameters",
  "/decision",
  "/camera/upper/calibration",
  "/camera/lower/calibration",
]);
const SERVICES = [
  "parameter_list",
  "set_parameters",
  "note",
  "scripts",
  "script",
  "check_script",
  "save_script",
  "machine",
];
const POLICY = [
  "default-src 'none'",
  "script-src 'self'",
  "style-src 'self'",
  "connect-src 'self'",
  "img-src 'self' blob: data:",
  "base-uri 'none'",
].join("; ");
const TYPES = {
  html: "text/html; charset=utf-8",
  js: "text/javascript; charset=utf-8",
  css: "text/css; charset=utf-8",
};
const STEP = 10; // ms
const FRAME = 33_333_333n; // ns
const SECOND = 1_000_000_000n; // ns
const NANOSECONDS = 1e6; // in a millisecond

/// The texts of the scripts below a folder, by name.
export function readScripts(folder) {
  const files = readdirSync(folder, { recursive: true }).filter((file) => file.endsWith(".lua"));
  return new Map(files.sort().map((file) => [file, readFileSync(join(folder, file), "utf8")]));
}

/// The stand-in for `reorient check`: each `!!` of a text is an error.
function findingsIn(file, text) {
  return text.split("\n").flatMap((line, i) => {
    const at = line.indexOf("!!");
    const column = Buffer.byteLength(line.slice(0, at)) + 1;
    return at < 0 ? [] : [{ file, line: i + 1, column, severity: "error", message: "unexpected symbol near '!'" }];
  });
}

export class Robot {
  /// `folder`: that of the built page; `speed`: times real time; `from`: s of the recording at which it starts; `loop`:
  /// after the recording another run begins, otherwise the robot stands still; `refusal`: why clients may change
  /// nothing; `scripts`: texts by name; `machines`: definitions, as `reorient graph --format json` prints them.
  constructor({
    recording,
    folder,
    parameters = [],
    speed = 1,
    from = 0,
    loop = true,
    refusal = "",
    scripts = new Map(),
    machines = [],
  }) {
    Object.assign(this, { recording, folder, parameters, speed, from, loop, refusal, scripts, machines });
    this.byName = new Map(parameters.map((it) => [it.name, { ...it }]));
    this.topics = new Map(recording.channels.map((it) => [it.id, it.topic]));
    this.session = 1;
    this.received = []; // messages of clients, for tests
    this.paths = []; // of the connections
    this.clients = new Map(); // socket: {subscriptions: Map(channel: subscription), watches: Set(name)}
    this.rewind();
  }

  rewind() {
    this.begin = this.recording.messages[0].time + BigInt(Math.round(1e9 * this.from));
    this.now = this.begin;
    this.next = 0;
    this.lasting = new Map(); // channel: message
    while (this.recording.messages[this.next]?.time < this.begin) this.remember(this.recording.messages[this.next++]);
  }

  remember(message) {
    if (LASTING.has(this.topics.get(message.channel))) this.lasting.set(message.channel, message);
  }

  /// Listens. `port` 0: any free one, which `this.port` contains afterwards.
  async start(port = 0) {
    this.server = createServer((request, response) => this.serve(request, response));
    this.sockets = new WebSocketServer({
      server: this.server,
      handleProtocols: (names) => (names.has(SUBPROTOCOL) ? SUBPROTOCOL : false),
    });
    this.sockets.on("connection", (socket, request) => {
      this.paths.push(request.url);
      this.welcome(socket);
    });
    await new Promise((done, failed) => this.server.once("error", failed).listen(port, "127.0.0.1", done));
    this.port = this.server.address().port;
    this.last = performance.now();
    this.timer = setInterval(() => this.advance(), STEP);
  }

  /// Closes everything at once, as a robot that is switched off.
  async stop() {
    clearInterval(this.timer);
    for (const socket of this.clients.keys()) socket.terminate();
    this.clients.clear();
    this.server.closeAllConnections();
    await new Promise((done) => this.server.close(done));
  }

  serve(request, response) {
    const path = new URL(request.url, "http://robot").pathname;
    const name = path === "/" || path === "/audience" ? "index.html" : path.slice(1);
    const type = TYPES[name.split(".").pop()];
    if (!/^(index\.html|live\.js|live\.css|editor\.js)$/.test(name)) {
      response.writeHead(404).end();
      return;
    }
    response.writeHead(200, { "Content-Type": type, "Content-Security-Policy": POLICY, "Cache-Control": "no-store" });
    response.end(readFileSync(join(this.folder, name)));
  }

  welcome(socket) {
    const client = { subscriptions: new Map(), watches: new Set() };
    this.clients.set(socket, client);
    socket.on("close", () => this.clients.delete(socket));
    socket.on("message", (data, isBinary) =>
      isBinary ? this.answerService(socket, data) : this.answer(socket, client, JSON.parse(data)),
    );
    const say = (message) => socket.send(JSON.stringify(message));
    say({
      op: "serverInfo",
      name: "Reorient",
      capabilities: ["parameters", "parametersSubscribe", "services"],
      supportedEncodings: ["json"],
      metadata: {},
      sessionId: String(this.session),
    });
    say({ op: "advertise", channels: this.recording.channels });
    if (this.refusal) say({ op: "status", level: 0, message: this.refusal, id: "access" });
    const schema = { encoding: "json", schemaName: "", schemaEncoding: "jsonschema", schema: "{}" };
    say({
      op: "advertiseServices",
      services: SERVICES.map((name, i) => ({ id: i + 1, name, type: name, request: schema, response: schema })),
    });
  }

  answer(socket, client, message) {
    this.received.push(message);
    const { op } = message;
    if (op === "subscribe") {
      for (const { id, channelId } of message.subscriptions) {
        client.subscriptions.set(channelId, id);
        const lasting = this.lasting.get(channelId);
        if (lasting) this.send(socket, id, lasting.time, lasting.data);
      }
    } else if (op === "getParameters") {
      socket.send(
        JSON.stringify({
          op: "parameterValues",
          id: message.id,
          parameters: [...this.byName.values()].map(({ name, value }) => ({ name, value })),
        }),
      );
    } else if (op === "setParameters") {
      socket.send(
        JSON.stringify({ op: "parameterValues", id: message.id, parameters: this.setParameters(message.parameters) }),
      );
    } else if (op === "subscribeParameterUpdates") {
      for (const name of message.parameterNames) client.watches.add(name);
    }
  }

  /// Sets values within their ranges. Returns the values that are in force.
  setParameters(list) {
    return list.map(({ name, value }) => {
      const parameter = this.byName.get(name);
      if (!parameter) return { name };
      const isAccepted = typeof value === typeof parameter.value && !(value < parameter.min || value > parameter.max);
      if (isAccepted) Object.assign(parameter, { value, origin: "live" });
      this.log(isAccepted ? 2 : 3, "parameters", `${name} = ${value}${isAccepted ? "" : ": out of range"}`);
      return { name, value: parameter.value };
    });
  }

  answerService(socket, data) {
    const [service, call, length] = [data.readUInt32LE(1), data.readUInt32LE(5), data.readUInt32LE(9)];
    const name = SERVICES[service - 1];
    const request = JSON.parse(data.subarray(13 + length).toString() || "{}");
    this.received.push({ op: "service", name, request });
    const answers = {
      parameter_list: () => ({ parameters: [...this.byName.values()] }),
      set_parameters: () => ({ parameters: this.setParameters(request.parameters) }),
      note: () => (this.note(request.text), {}),
      scripts: () => ({ files: [...this.scripts.keys()] }),
      script: () => ({ file: request.file, text: this.textOf(request.file) }),
      check_script: () => ({ findings: findingsIn(request.file, request.text) }),
      save_script: () => this.saveScript(request),
      machine: () => ({ time: 1e-9 * Number(this.now), machine: this.machineOf(request.machine) }),
    };
    let answer;
    try {
      answer = answers[name]();
    } catch (error) {
      socket.send(
        JSON.stringify({ op: "serviceCallFailure", serviceId: service, callId: call, message: error.message }),
      );
      return;
    }
    const payload = Buffer.from(JSON.stringify(answer));
    const head = Buffer.alloc(13);
    head.writeUInt8(3, 0);
    head.writeUInt32LE(service, 1);
    head.writeUInt32LE(call, 5);
    head.writeUInt32LE(4, 9);
    socket.send(Buffer.concat([head, Buffer.from("json"), payload]));
  }

  textOf(file) {
    if (!this.scripts.has(file)) throw new Error(`unknown script '${file}'`);
    return this.scripts.get(file);
  }

  machineOf(name) {
    const found = this.machines.find((it) => it.name === name);
    if (!found) throw new Error(`unknown machine '${name}'`);
    return found;
  }

  /// Saves a script that is still the expected one. The log has the result of the reload.
  saveScript({ file, text, expected }) {
    if (this.refusal) throw new Error(`save_script: refused: ${this.refusal}`);
    if (this.textOf(file) !== expected) return { file, saved: false, text: this.textOf(file) };
    this.scripts.set(file, text);
    const [fault] = findingsIn(file, text);
    const where = fault && `${file}:${fault.line}:${fault.column}: ${fault.message}`;
    if (fault) this.log(4, file, `edit rejected; keeping the previous version: ${where}`, file, fault.line);
    else this.log(2, file, "the edit is running");
    return { file, saved: true, text };
  }

  note(text) {
    this.broadcast("/events", { machine: "note", state: `note: ${text}`, command: "", verdict: "", reason: "" });
    this.log(2, "note", `note: ${text}`);
  }

  log(level, name, message, file = "", line = 0) {
    const timestamp = { sec: Number(this.now / 1000000000n), nsec: Number(this.now % 1000000000n) };
    this.broadcast("/log", { timestamp, level, name, message, file, line });
  }

  /// Sends a message that is not in the recording.
  broadcast(topic, value) {
    const channel = this.recording.channels.find((it) => it.topic === topic)?.id;
    const data = Buffer.from(JSON.stringify(value));
    for (const [socket, { subscriptions }] of this.clients)
      if (subscriptions.has(channel)) this.send(socket, subscriptions.get(channel), this.now, data);
  }

  /// Sends a status to all clients. A later one with the same id replaces it.
  report(level, message, id = undefined) {
    for (const socket of this.clients.keys()) socket.send(JSON.stringify({ op: "status", level, message, id }));
  }

  /// Removes a status.
  removeReport(id) {
    for (const socket of this.clients.keys()) socket.send(JSON.stringify({ op: "removeStatus", statusIds: [id] }));
  }

  send(socket, subscription, time, data) {
    const head = Buffer.alloc(13);
    head.writeUInt8(1, 0);
    head.writeUInt32LE(subscription, 1);
    head.writeBigUInt64LE(time, 5);
    socket.send(Buffer.concat([head, data]));
  }

  /// Sends the last world and the last states again, with the present time, and each second the last room.
  standStill() {
    if (this.now - (this.stoodAt ?? 0n) < FRAME) return;
    const isNewSecond = this.now / SECOND !== (this.stoodAt ?? 0n) / SECOND;
    this.stoodAt = this.now;
    for (const topic of ["/world", "/machines", "/conditions", ...(isNewSecond ? ["/room", "/wall"] : [])]) {
      const last = this.recording.messages.findLast((it) => this.topics.get(it.channel) === topic);
      if (!last) continue; // a recording of an earlier version
      const { channel, data } = last;
      for (const [socket, { subscriptions }] of this.clients)
        if (subscriptions.has(channel)) this.send(socket, subscriptions.get(channel), this.now, data);
    }
  }

  advance() {
    const at = performance.now();
    this.now += BigInt(Math.round((at - this.last) * this.speed * NANOSECONDS));
    this.last = at;
    const { messages } = this.recording;
    for (; this.next < messages.length && messages[this.next].time <= this.now; ++this.next) {
      const message = messages[this.next];
      this.remember(message);
      for (const [socket, { subscriptions }] of this.clients)
        if (subscriptions.has(message.channel))
          this.send(socket, subscriptions.get(message.channel), message.time, message.data);
    }
    if (this.next < messages.length) return;
    if (!this.loop) {
      this.standStill();
      return;
    }
    ++this.session; // another run
    this.rewind();
    for (const socket of this.clients.keys()) socket.close();
  }
}
