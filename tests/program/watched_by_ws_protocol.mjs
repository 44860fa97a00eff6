// SPDX-License-Identifier: MIT
// watched_by_ws_protocol.mjs LINK: watches a run with Foxglove's own client, under both names of the protocol: all topics,
// all parameters, a change of one, and a service.
import protocol from "@foxglove/ws-protocol";
import Ajv from "ajv";
import { isDeepStrictEqual } from "node:util";
import WebSocket from "ws";

const { FoxgloveClient } = protocol;
const link = process.argv[2].replace(/^http/, "ws");
const require = (holds, what) => {
  if (holds) return;
  console.error(what);
  process.exit(1);
};
const textOf = (data) => new TextDecoder().decode(data);
// Topics that this run may not fill: rare events, and a camera that it does not use.
const isRare = (topic) => topic === "/log" || topic === "/events" || topic.startsWith("/camera/lower");

async function watch(subprotocol) {
  const client = new FoxgloveClient({ ws: new WebSocket(link, [subprotocol]) });
  client.on("error", (error) => require(false, `${subprotocol}: ${error}`));
  const next = (event, matches = () => true) =>
    new Promise((resolve) => {
      const listener = (value) => {
        if (!matches(value)) return;
        client.off(event, listener);
        resolve(value);
      };
      client.on(event, listener);
    });
  const [info, channels, services] = await Promise.all([next("serverInfo"), next("advertise"), next("advertiseServices")]);
  require(info.capabilities.includes("parameters") && info.capabilities.includes("services"), `capabilities: ${info.capabilities}`);

  let now = 0n; // of the robot
  client.on("time", ({ timestamp }) => (now = timestamp));
  const ajv = new Ajv({ strict: false, validateFormats: false });
  const bySubscription = new Map();
  const missing = new Set();
  for (const channel of channels) {
    bySubscription.set(client.subscribe(channel.id), { channel, validate: ajv.compile(JSON.parse(channel.schema)) });
    if (!isRare(channel.topic)) missing.add(channel.topic);
  }
  await next("message", ({ subscriptionId, timestamp, data }) => {
    const { channel, validate } = bySubscription.get(subscriptionId);
    const message = JSON.parse(textOf(data));
    require(validate(message), `${channel.topic}: ${ajv.errorsText(validate.errors)}`);
    require(timestamp >= 0n, `${channel.topic}: time ${timestamp}`);
    // Rare and lasting messages may be of another frame.
    if (channel.topic === "/world") require(timestamp === now, `/world: time ${timestamp}, found the clock ${now}`);
    missing.delete(channel.topic);
    return missing.size === 0;
  });

  const values = async (id, ask) => {
    const answer = next("parameterValues", (one) => one.id === id);
    ask(id);
    return (await answer).parameters;
  };
  const all = await values("all", (id) => client.getParameters([], id));
  require(all.length > 100, `${all.length} parameters`);
  const name = "orientation.lingering";
  const set = await values("set", (id) => client.setParameters([{ name, value: 0.4, type: "float64" }], id));
  require(isDeepStrictEqual(set, [{ name, value: 0.4, type: "float64" }]), `set: ${JSON.stringify(set)}`);

  const call = async (service, request) => {
    const serviceId = services.find((one) => one.name === service).id;
    const answer = Promise.race([next("serviceCallResponse"), next("serviceCallFailure")]);
    client.sendServiceCallRequest({ serviceId, callId: 7, encoding: "json", data: new TextEncoder().encode(JSON.stringify(request)) });
    const { data, message } = await answer;
    require(data !== undefined, `${service}: ${message}`);
    return JSON.parse(textOf(data));
  };
  const list = (await call("parameter_list", {})).parameters;
  require(list.find((one) => one.name === name).value === 0.4, `${name} is not the value that was set`);
  require((await call("note", { text: subprotocol })).time > 0, "a note has a time");
  require((await call("undo", {})).parameters[0].name === name, "the change is undone");
  client.close();
}

await watch("foxglove.websocket.v1");
await watch("foxglove.sdk.v1");
process.exit(0);
