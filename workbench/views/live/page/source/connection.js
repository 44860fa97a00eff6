// SPDX-License-Identifier: MIT
// The connection to the robot: subscribes to topics, calls services, sets parameters, and connects again by itself.
import { SUBPROTOCOL, readBinary, readJson, readText, serviceRequest } from "./protocol.js";

const FIRST_RETRY = 1000; // ms
const LONGEST_RETRY = 3000;
const SILENCE = 10000; // after this time without any message the connection is opened again
const SERVICE_TIMEOUT = 5000;
// Their answers come with the next frame, which a paused run has not.
const NEEDS_FRAME = new Set(["note", "reload", "set_parameters", "undo"]);

/// Events that `listener(name, value)` receives: "state", "server", "message", "status", "parameters", "services",
/// "playback", "bad".
export class Connection {
  constructor(url, topics, listener) {
    this.url = url;
    this.topics = new Set(topics);
    this.listener = listener;
    this.state = "connecting";
    this.server = null;
    this.services = new Map(); // name: id
    this.channels = new Map(); // id: topic
    this.subscriptions = new Map(); // id: topic
    this.calls = new Map(); // id: {name, resolve, reject, timeout, timer}
    this.nextId = 1;
    this.retry = FIRST_RETRY;
    this.lastHeard = 0;
    this.reason = ""; // that the robot gave when it ended the connection, until a robot answers
    this.isPaused = false; // the run, as last reported
    this.watch = setInterval(() => this.checkSilence(), 1000);
    this.open();
  }

  open() {
    const socket = new WebSocket(this.url, [SUBPROTOCOL]);
    this.socket = socket;
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      this.lastHeard = Date.now();
    };
    socket.onmessage = (event) => {
      this.lastHeard = Date.now();
      this.receive(event.data);
    };
    socket.onclose = (event) => this.closed(socket, event.reason);
  }

  close() {
    clearInterval(this.watch);
    clearTimeout(this.timer);
    this.socket.onclose = null;
    this.socket.close();
  }

  closed(socket, reason = "") {
    if (socket !== this.socket) return;
    this.channels.clear();
    this.subscriptions.clear();
    this.services.clear();
    this.server = null;
    for (const call of this.calls.values()) {
      clearTimeout(call.timer);
      call.reject(new Error("the connection was closed"));
    }
    this.calls.clear();
    if (reason) this.reason = reason; // a failed retry has none
    this.setState("closed");
    this.timer = setTimeout(() => this.open(), this.retry);
    this.retry = Math.min(LONGEST_RETRY, this.retry + 500);
  }

  checkSilence() {
    if (this.state !== "open" || Date.now() - this.lastHeard < SILENCE) return;
    const silent = this.socket;
    silent.close();
    this.closed(silent); // a dead network does not answer the close
  }

  setState(state) {
    this.state = state;
    this.listener("state", state);
  }

  receive(data) {
    try {
      if (typeof data === "string") this.receiveText(readText(data));
      else this.receiveBinary(readBinary(data));
    } catch (error) {
      this.listener("bad", error.message);
    }
  }

  receiveText(message) {
    const { op } = message;
    if (op === "serverInfo") {
      this.server = message;
      this.retry = FIRST_RETRY;
      this.reason = "";
      this.listener("server", message);
      this.setState("open");
    } else if (op === "advertise") {
      this.subscribe(message.channels);
    } else if (op === "unadvertise") {
      for (const id of message.channelIds) this.channels.delete(id);
    } else if (op === "advertiseServices") {
      for (const { id, name } of message.services) this.services.set(name, id);
      this.listener("services", this.services);
    } else if (op === "unadvertiseServices") {
      for (const [name, id] of this.services) if (message.serviceIds.includes(id)) this.services.delete(name);
      this.listener("services", this.services);
    } else if (op === "parameterValues") {
      this.listener("parameters", message);
    } else if (op === "status" || op === "removeStatus") {
      this.listener("status", message);
    } else if (op === "serviceCallFailure") {
      this.finishCall(message.callId, null, new Error(message.message));
    }
  }

  receiveBinary(message) {
    if (message.op === "messageData") {
      const topic = this.subscriptions.get(message.subscription);
      if (topic) this.listener("message", { topic, time: message.time, payload: message.payload });
    } else if (message.op === "playbackState") {
      this.listener("playback", message);
    } else if (message.op === "serviceResponse") {
      this.finishCall(message.call, readJson(message.payload), null);
    }
  }

  subscribe(channels) {
    const subscriptions = [];
    for (const { id, topic, encoding } of channels) {
      this.channels.set(id, topic);
      if (encoding !== "json" || !this.topics.has(topic)) continue;
      const subscription = this.nextId++;
      this.subscriptions.set(subscription, topic);
      subscriptions.push({ id: subscription, channelId: id });
    }
    if (subscriptions.length) this.send({ op: "subscribe", subscriptions });
  }

  send(message) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message));
  }

  sendBinary(bytes) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(bytes);
  }

  has(capability) {
    return this.server?.capabilities?.includes(capability) ?? false;
  }

  /// Calls a service that the robot advertises. The promise rejects with the robot's reason, or after `timeout` ms. A
  /// call that needs a frame waits as long as the run is paused.
  call(name, value, timeout = SERVICE_TIMEOUT) {
    const service = this.services.get(name);
    if (service === undefined) return Promise.reject(new Error(`the robot has no service ${name}`));
    const call = this.nextId++;
    return new Promise((resolve, reject) => {
      this.calls.set(call, { name, resolve, reject, timeout });
      this.awaitAnswer(call);
      this.socket.send(serviceRequest(service, call, value));
    });
  }

  awaitAnswer(id) {
    const call = this.calls.get(id);
    call.timer = setTimeout(() => {
      if (this.isPaused && NEEDS_FRAME.has(call.name)) this.awaitAnswer(id);
      else this.finishCall(id, null, new Error(this.lateText(call)));
    }, call.timeout);
  }

  lateText({ name, timeout }) {
    const state = this.isPaused ? "The run is paused, but this needs no frame" : "The run is not paused";
    return `No answer to ${name} within ${timeout / 1000} s. ${state}: a computer or the connection is busy.`;
  }

  finishCall(id, value, error) {
    const call = this.calls.get(id);
    if (!call) return;
    this.calls.delete(id);
    clearTimeout(call.timer);
    if (error) call.reject(error);
    else call.resolve(value);
  }
}
