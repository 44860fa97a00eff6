// SPDX-License-Identifier: MIT
// read_by_mcap_core.mjs FILE FRAMES: reads a recording by its index and as a stream, and compares the results. Checks that every
// JSON message fits its schema, and that schemas with Foxglove's names are those that Foxglove publishes.
import published from "@foxglove/schemas/jsonschema.js";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { loadDecompressHandlers } from "@mcap/support";
import Ajv from "ajv";
import { readFileSync } from "node:fs";
import { isDeepStrictEqual } from "node:util";

const [file, frames] = process.argv.slice(2);
const bytes = new Uint8Array(readFileSync(file));
const decompressHandlers = await loadDecompressHandlers();
const require = (holds, what) => {
  if (holds) return;
  console.error(`${file}: ${what}`);
  process.exit(1);
};

const readable = {
  size: async () => BigInt(bytes.length),
  read: async (offset, length) => bytes.slice(Number(offset), Number(offset + length)),
};
const indexed = await McapIndexedReader.Initialize({ readable, decompressHandlers });

const validators = new Map();
// Descriptions may differ.
const withoutWords = (schema) => {
  if (Array.isArray(schema)) return schema.map(withoutWords);
  if (schema === null || typeof schema !== "object") return schema;
  const words = ["description", "title", "$comment"];
  return Object.fromEntries(
    Object.entries(schema)
      .filter(([key, value]) => !(words.includes(key) && typeof value === "string"))
      .map(([key, value]) => [key, withoutWords(value)]),
  );
};
let compared = 0;
for (const { id, name, encoding, data } of indexed.schemasById.values()) {
  if (encoding !== "jsonschema") {
    require(name === "reorient/Bytes" && encoding === "ros1msg", `a schema ${name} in ${encoding}`);
    continue;
  }
  const schema = JSON.parse(new TextDecoder().decode(data));
  validators.set(id, new Ajv({ strict: false }).compile(schema));
  if (!name.startsWith("foxglove.")) continue;
  const theirs = withoutWords(published[name.slice("foxglove.".length)]);
  require(isDeepStrictEqual(withoutWords(schema), theirs), `${name} differs from the schema that Foxglove publishes`);
  ++compared;
}

const byTopic = {};
let messages = 0n, last = -1n, valid = 0;
for await (const message of indexed.readMessages()) {
  const { topic, schemaId, messageEncoding } = indexed.channelsById.get(message.channelId);
  byTopic[topic] = (byTopic[topic] ?? 0) + 1;
  require(message.logTime >= last, "times go back");
  last = message.logTime;
  ++messages;
  if (messageEncoding === "ros1") {  // bytes behind their number
    const view = new DataView(message.data.buffer, message.data.byteOffset, message.data.byteLength);
    require(view.getUint32(0, true) === message.data.byteLength - 4, `${topic}: not as many bytes as it says`);
    continue;
  }
  require(messageEncoding === "json", `${topic} is in ${messageEncoding}`);
  const json = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(message.data));
  if (topic.endsWith("/image"))
    require(Buffer.from(json.data, "base64").readUInt16BE(0) === 0xffd8, `${topic} is no JPEG`);
  const fits = validators.get(schemaId);
  require(fits, `${topic} has no JSON schema`);
  require(fits(json), `${topic}: ${JSON.stringify(fits.errors)}`);
  ++valid;
}
require(messages === indexed.statistics.messageCount, "the statistics count other messages");
require(byTopic["/reorient/frame"] === Number(frames), `${byTopic["/reorient/frame"]} frames instead of ${frames}`);
require(byTopic["/world"] === Number(frames), `${byTopic["/world"]} messages of /world instead of ${frames}`);
for (const topic of ["/field", "/wall", "/parameters", "/camera/upper/calibration"])
  require(byTopic[topic] >= 1, `nothing of ${topic}`);
require(indexed.statistics.messageEndTime === last, "the statistics end at another time");
for await (const metadata of indexed.readMetadata()) require(metadata.metadata.has("version"), "no version is told");

const stream = new McapStreamReader({ validateCrcs: true, decompressHandlers });
stream.append(bytes);
let streamed = 0n;
for (let record; (record = stream.nextRecord()); ) streamed += record.type === "Message" ? 1n : 0n;
require(stream.done(), "the stream has no end");
require(streamed === messages, "the stream has other messages than the index");
console.log(`${file}: ${messages} messages, ${valid} fit their schemas; ${compared} schemas are Foxglove's`);
