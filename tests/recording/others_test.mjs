// Our recordings are read by npm's @mcap/core, each message decoded with @foxglove/omgidl-parser and -serialization and
// encoded again to the same bytes; and what @mcap/core writes is read by `tandem`.
//   node others_test.mjs --build build
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { parseArgs } from "node:util";

import { parseIDL } from "@foxglove/omgidl-parser";
import { MessageReader, MessageWriter } from "@foxglove/omgidl-serialization";
import * as foxgloveSchemas from "@foxglove/schemas/jsonschema.js";
import * as zstd from "@foxglove/wasm-zstd";
import { McapIndexedReader, McapStreamReader, McapWriter } from "@mcap/core";
import Ajv from "ajv";
import lz4 from "lz4js";

const { values: options } = parseArgs({ options: { build: { type: "string" } } });
const tandem = join(options.build, "bin", "tandem");
const folder = mkdtempSync(join(tmpdir(), "tandem_test_"));
const decompressHandlers = {
  zstd: (packed, size) => zstd.decompress(packed, Number(size)),
  lz4: (packed, size) => lz4.decompress(packed, Number(size)),
};
const text = new TextEncoder();

/** All of a file by @mcap/core's stream reader, which checks every checksum. */
function streamed(file) {
  const reader = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  reader.append(readFileSync(file));
  const all = { schemas: new Map(), channels: new Map(), messages: [], attachments: [], metadata: [] };
  for (let record = reader.nextRecord(); record; record = reader.nextRecord()) {
    if (record.type === "Schema") all.schemas.set(record.id, record);
    if (record.type === "Channel") all.channels.set(record.id, record);
    if (record.type === "Message") all.messages.push(record);
    if (record.type === "Attachment") all.attachments.push(record);
    if (record.type === "Metadata") all.metadata.push(record);
  }
  assert.ok(reader.done(), `${file}: ends before its end`);
  return all;
}

async function indexedReader(file) {
  const bytes = readFileSync(file);
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, size) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + size))),
  };
  return await McapIndexedReader.Initialize({ readable, decompressHandlers });
}

/** Decodes a message by the schema in its own file, and encodes it again. */
function assertExplainsItself(all, message) {
  const channel = all.channels.get(message.channelId);
  const schema = all.schemas.get(channel.schemaId);
  assert.equal(channel.messageEncoding, "cdr", channel.topic);
  assert.equal(schema.encoding, "omgidl", channel.topic);
  const definitions = parseIDL(new TextDecoder().decode(schema.data));
  const decoded = new MessageReader(schema.name, definitions).readMessage(message.data);
  const again = new MessageWriter(schema.name, definitions).writeMessage(decoded);
  assert.deepEqual(Buffer.from(again), Buffer.from(message.data), `${channel.topic}: ${JSON.stringify(decoded, (_, value) => typeof value === "bigint" ? `${value}` : value)}`);
}

async function checkOurs() {
  execFileSync(join(options.build, "tests", "write_samples"), [folder]);
  const golden = readFileSync(new URL("../idl/golden_bytes.txt", import.meta.url), "utf8").trim().split("\n");
  for (const name of ["live", "none", "zstd", "lz4"]) {
    const file = join(folder, `${name}.mcap`);
    const all = streamed(file);
    assert.equal(all.messages.length, golden.length, file);
    assert.deepEqual([...all.metadata[0].metadata], [["version", "test"]]);
    assert.equal(new TextDecoder().decode(all.attachments[0].data), 'host = "robot"\n');
    all.messages.forEach((message, i) => {
      const [topic, hex] = golden[i].split(" ");
      assert.equal(all.channels.get(message.channelId).topic, topic);
      assert.equal(Buffer.from(message.data).toString("hex"), hex, topic);
      assertExplainsItself(all, message);
    });
    if (name === "live") continue; // without index, as it is while it is recorded
    const reader = await indexedReader(file);
    let count = 0;
    for await (const message of reader.readMessages({ validateCrcs: true })) {
      assert.deepEqual(message.data, all.messages[count].data, `${file}: message ${count}`);
      ++count;
    }
    assert.equal(count, golden.length, file);
    assert.equal(reader.statistics.messageCount, BigInt(golden.length), file);
    console.log(`${name}.mcap: ${count} messages of ${all.channels.size} topics decoded and encoded to the same bytes`);
  }
}

/** A file by @mcap/core: two topics, one without schema, messages not in order of their times. */
async function writeTheirs(file, writerOptions) {
  const parts = [];
  let size = 0;
  const writable = {
    position: () => BigInt(size),
    write: async (bytes) => {
      parts.push(Buffer.from(bytes));
      size += bytes.length;
    },
  };
  const writer = new McapWriter({ writable, chunkSize: 1000, ...writerOptions });
  await writer.start({ profile: "", library: "another" });
  const schemaId = await writer.registerSchema({ name: "a::B", encoding: "omgidl", data: text.encode("module a { struct B { long c; }; };") });
  const known = await writer.registerChannel({ schemaId, topic: "known", messageEncoding: "cdr", metadata: new Map([["of", "another"]]) });
  const raw = await writer.registerChannel({ schemaId: 0, topic: "raw", messageEncoding: "json", metadata: new Map() });
  for (let i = 0; i < 100; ++i) {
    const time = BigInt(1000 + 10 * (i ^ 1)); // neighbours exchanged
    await writer.addMessage({ channelId: known, sequence: i, logTime: time, publishTime: time - 1n, data: text.encode(`known ${"k".repeat(i)} ${i}`) });
    await writer.addMessage({ channelId: raw, sequence: i, logTime: time + 1n, publishTime: time, data: text.encode(`{"number":${i}}`) });
  }
  await writer.addAttachment({ name: "notes.txt", logTime: 5n, createTime: 6n, mediaType: "text/plain", data: text.encode("seen") });
  await writer.addMetadata({ name: "trial", metadata: new Map([["number", "7"]]) });
  await writer.end();
  writeFileSync(file, Buffer.concat(parts));
}

const asText = (all) =>
  all.messages
    .map((message) => `${String(message.logTime).padStart(8, "0")} ${all.channels.get(message.channelId).topic} ${message.publishTime} ${message.sequence} ${Buffer.from(message.data).toString("hex")}`)
    .sort();

async function checkTheirs() {
  const forms = {
    unchunked: { useChunks: false },
    chunked: { useChunks: true },
    zstd: { compressChunk: (data) => ({ compression: "zstd", compressedData: zstd.compress(data) }) },
    lz4: { compressChunk: (data) => ({ compression: "lz4", compressedData: lz4.compress(data) }) },
    bare: { useStatistics: false, useSummaryOffsets: false, useMessageIndex: false, useChunkIndex: false, repeatChannels: false, repeatSchemas: false },
  };
  for (const [name, writerOptions] of Object.entries(forms)) {
    const file = join(folder, `theirs_${name}.mcap`);
    await writeTheirs(file, writerOptions);
    const info = JSON.parse(execFileSync(tandem, ["info", "--json", file], { encoding: "utf8" }));
    assert.equal(info.complete, true, name);
    assert.equal(info.messages, 200, name);
    assert.deepEqual(info.topics.map((topic) => [topic.topic, topic.type, topic.count]), [["known", "a::B", 100], ["raw", "", 100]]);
    assert.deepEqual(info.metadata, { trial: { number: "7" } });
    assert.deepEqual(info.attachments, ["notes.txt"]);

    // What we read is what we write, and that they read again.
    const ours = join(folder, `ours_${name}.mcap`);
    execFileSync(tandem, ["recover", file, "-o", ours], { stdio: "ignore" });
    const before = streamed(file);
    const after = streamed(ours);
    assert.deepEqual(asText(after), asText(before), name);
    assert.deepEqual([...after.channels.values()].map((channel) => [channel.topic, [...channel.metadata]]),
      [...before.channels.values()].map((channel) => [channel.topic, [...channel.metadata]]));
    assert.equal(new TextDecoder().decode(after.attachments[0].data), "seen");
    console.log(`theirs, ${name}: ${info.messages} messages, the same bytes`);
  }
}

/** The fields of a schema and of what is nested in it, by path. */
function fieldsOf(schema, path = "") {
  if (schema.type === "array") return fieldsOf(schema.items, `${path}[]`);
  const fields = Object.entries(schema.properties ?? {});
  return fields.flatMap(([name, field]) => [`${path}.${name}`, ...fieldsOf(field, `${path}.${name}`)]);
}

async function checkFoxglove() {
  const file = join(folder, "foxglove.mcap");
  execFileSync(tandem, ["export", "foxglove", join(folder, "zstd.mcap"), "-o", file], { stdio: "ignore" });
  const all = streamed(file);
  const ajv = new Ajv({ strict: false });
  for (const schema of all.schemas.values()) {
    assert.equal(schema.encoding, "jsonschema");
    const standard = foxgloveSchemas[schema.name.replace("foxglove.", "")];
    const ours = JSON.parse(new TextDecoder().decode(schema.data));
    assert.deepEqual(fieldsOf(ours).sort(), fieldsOf(standard).sort(), schema.name);
  }
  for (const message of all.messages) {
    const channel = all.channels.get(message.channelId);
    const name = all.schemas.get(channel.schemaId).name;
    const validate = ajv.compile(foxgloveSchemas[name.replace("foxglove.", "")]);
    assert.ok(validate(JSON.parse(new TextDecoder().decode(message.data))), `${channel.topic}: ${ajv.errorsText(validate.errors)}`);
  }
  const topics = [...all.channels.values()].map((channel) => channel.topic).sort();
  assert.deepEqual(topics, ["/belief", "/found", "/ground_truth", "/map", "/people", "/plan", "/scan", "/sources", "/team", "/tf"]);
  console.log(`foxglove: ${all.messages.length} messages of ${topics.length} topics are what the standard schemas say`);
}

try {
  await zstd.isLoaded;
  await checkOurs();
  await checkTheirs();
  await checkFoxglove();
} finally {
  rmSync(folder, { recursive: true });
}
