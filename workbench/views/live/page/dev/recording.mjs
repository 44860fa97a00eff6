// SPDX-License-Identifier: MIT
// Reads the messages for viewers from a recording.
import { readFileSync } from "node:fs";

import { load } from "../packages.mjs";

const { McapIndexedReader } = load("@mcap/core");
const { loadDecompressHandlers } = load("@mcap/support");

/// {channels: [{id, topic, encoding, schemaName, schema, schemaEncoding}], messages: [{channel, time, data}]}; times
/// are ns as bigint.
export async function readRecording(file) {
  const bytes = new Uint8Array(readFileSync(file));
  const reader = await McapIndexedReader.Initialize({
    readable: {
      size: async () => BigInt(bytes.length),
      read: async (offset, length) => bytes.slice(Number(offset), Number(offset + length)),
    },
    decompressHandlers: await loadDecompressHandlers(),
  });
  const decoder = new TextDecoder();
  const channels = [...reader.channelsById.values()]
    .filter((channel) => channel.messageEncoding === "json")
    .map(({ id, topic, messageEncoding, schemaId }) => {
      const { name, encoding, data } = reader.schemasById.get(schemaId);
      return {
        id: id + 1,
        topic,
        encoding: messageEncoding,
        schemaName: name,
        schemaEncoding: encoding,
        schema: decoder.decode(data),
      };
    });
  const messages = [];
  for await (const { channelId, logTime, data } of reader.readMessages({
    topics: channels.map((channel) => channel.topic),
  }))
    messages.push({ channel: channelId + 1, time: logTime, data });
  return { channels, messages };
}

/// The descriptions of parameters from the output of `reorient params`.
export function parseParameters(text) {
  const typed = (word) =>
    word === "true" ? true : word === "false" ? false : Number.isFinite(Number(word)) ? Number(word) : word;
  const all = [];
  for (const line of text.split("\n")) {
    const match = /^(\S+)\s+(\S+)\s+(\S+)\s+(?:(\S+) to (\S+?)(?: ([^:]+))?|true or false|[^:]*): (.*)$/.exec(line);
    if (!match) continue;
    const [, name, value, origin, min, max, unit, description] = match;
    all.push({
      name,
      value: typed(value),
      default: typed(value),
      min: min && Number(min),
      max: max && Number(max),
      unit: unit ?? "",
      description,
      origin,
    });
  }
  return all;
}
