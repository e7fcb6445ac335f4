import { describe, expect, it } from "vitest";
import { parseClientMessage } from "../protocol/commands";
import { Outbox, type Storage } from "./outbox";

function memory(): Storage {
  let kept: string | undefined;
  return { load: () => kept, save: (text) => (kept = text) };
}
const named = () => "phone-0001";

describe("the outbox", () => {
  it("numbers commands from one without gaps", () => {
    const outbox = new Outbox(memory(), named);
    expect(outbox.add({ kind: "replan" }, 0).sequence).toBe(1);
    expect(outbox.add({ kind: "stop" }, 0).sequence).toBe(2);
  });
  it("keeps what is not acknowledged over a reload", () => {
    const storage = memory();
    const before = new Outbox(storage, named);
    before.add({ kind: "my_pose", x: 1, y: 2 }, 100);
    before.add({ kind: "replan" }, 200);
    before.acknowledge("phone-0001", 1);

    const after = new Outbox(storage, () => "phone-0002");
    expect(after.client).toBe("phone-0001");
    expect(after.waiting.map((one) => one.sequence)).toEqual([2]);
    expect(after.add({ kind: "stop" }, 300).sequence).toBe(3);
  });
  it("says how old a command is when it leaves, in a message the gateway understands", () => {
    const outbox = new Outbox(memory(), named);
    const command = outbox.add({ kind: "my_goal", x: 3, y: 4 }, 1000);
    const message = outbox.message(command, 3500, 77);
    expect(message).toMatchObject({ kind: "my_goal", x: 3, y: 4, age_ms: 2500, sent_at_ms: 77 });
    expect(parseClientMessage(JSON.stringify(message)).ok).toBe(true);
  });
  it("starts anew when what was kept is damaged", () => {
    const storage: Storage = { load: () => "{", save: () => undefined };
    expect(new Outbox(storage, named).waiting).toEqual([]);
  });
  it("ignores acknowledgements for another phone", () => {
    const outbox = new Outbox(memory(), named);
    outbox.add({ kind: "replan" }, 0);
    outbox.acknowledge("phone-9999", 1);
    expect(outbox.waiting.length).toBe(1);
  });
});
