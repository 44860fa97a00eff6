// read_by_mcap_core.mjs FILE FRAMES: reads a recording by its index and as a stream, and compares what each finds.
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { loadDecompressHandlers } from "@mcap/support";
import { readFileSync } from "node:fs";

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
const byTopic = {};
let messages = 0n, last = -1n;
for await (const message of indexed.readMessages()) {
  const { topic } = indexed.channelsById.get(message.channelId);
  byTopic[topic] = (byTopic[topic] ?? 0) + 1;
  require(message.logTime >= last, "times go back");
  last = message.logTime;
  ++messages;
}
require(messages === indexed.statistics.messageCount, "the statistics count other messages");
require(byTopic["/reorient/frame"] === Number(frames), `${byTopic["/reorient/frame"]} frames instead of ${frames}`);
require(indexed.statistics.messageEndTime === last, "the statistics end at another time");
for await (const metadata of indexed.readMetadata()) require(metadata.metadata.has("version"), "no version is told");

const stream = new McapStreamReader({ validateCrcs: true, decompressHandlers });
stream.append(bytes);
let streamed = 0n;
for (let record; (record = stream.nextRecord()); ) streamed += record.type === "Message" ? 1n : 0n;
require(stream.done(), "the stream has no end");
require(streamed === messages, "the stream has other messages than the index");
console.log(`${file}: ${messages} messages`);
