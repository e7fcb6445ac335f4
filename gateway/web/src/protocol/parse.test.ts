import { readFileSync, readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import Ajv from "ajv/dist/2020";
import { describe, expect, it } from "vitest";
import { parseBelief } from "./belief";
import { parseClientMessage } from "./commands";
import { parseMessage } from "./parse";

const folder = fileURLToPath(new URL("../../../protocol/", import.meta.url));
const examples = (kind: "valid" | "invalid") => readdirSync(`${folder}examples/${kind}`).sort();
const read = (kind: string, name: string) => readFileSync(`${folder}examples/${kind}/${name}`, "utf8");
const parse = (name: string, text: string) =>
  name.startsWith("client_") ? parseClientMessage(text) : parseMessage(text);

/** What only a parser that sees the text itself can refuse; the gateway's does. */
const kOnlyForTheGateway = new Set(["client_repeated_key.json"]);
/** What a schema cannot say, or what is not JSON at all. */
const kBeyondTheSchema = new Set([
  "client_empty.json",
  "client_not_json.json",
  "client_repeated_key.json",
  "client_number_not_finite.json",
  "client_server_message.json",
  "server_client_message.json",
  "server_map_with_a_cell_too_few.json",
]);

describe("messages", () => {
  it.each(examples("valid"))("reads %s", (name) => {
    expect(parse(name, read("valid", name))).toMatchObject({ ok: true });
  });
  it.each(examples("invalid").filter((name) => !kOnlyForTheGateway.has(name)))("refuses %s", (name) => {
    expect(parse(name, read("invalid", name)).ok).toBe(false);
  });
});

describe("the schema", () => {
  const schema: object = JSON.parse(readFileSync(`${folder}tandem.schema.json`, "utf8"));
  const validate = new Ajv({ strict: false }).compile(schema);
  it.each(examples("valid"))("accepts %s", (name) => {
    expect(validate(JSON.parse(read("valid", name)))).toBe(true);
  });
  it.each(examples("invalid").filter((name) => !kBeyondTheSchema.has(name)))("refuses %s", (name) => {
    expect(validate(JSON.parse(read("invalid", name)))).toBe(false);
  });
});

describe("the belief frame", () => {
  const frame = (cells: number) => {
    const view = new DataView(new ArrayBuffer(22 + cells));
    view.setUint8(0, 1);
    view.setUint8(1, 1);
    view.setUint16(2, 2, true);
    view.setUint16(4, 1, true);
    view.setFloat32(6, 0.5, true);
    view.setFloat32(10, -1, true);
    view.setUint32(18, 7, true);
    return view.buffer;
  };
  it("has a head and its cells", () => {
    expect(parseBelief(frame(2))).toMatchObject({
      ok: true,
      value: { width: 2, height: 1, resolution: 0.5, x: -1, y: 0, revision: 7 },
    });
  });
  it("is refused when cells are missing", () => {
    expect(parseBelief(frame(1)).ok).toBe(false);
    expect(parseBelief(new ArrayBuffer(3)).ok).toBe(false);
  });
});
