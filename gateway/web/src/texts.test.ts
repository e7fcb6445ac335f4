import { describe, expect, it } from "vitest";
import { kLanguages, languageFor } from "./texts";

describe("texts", () => {
  it("are there in every language", () => {
    for (const texts of Object.values(kLanguages)) {
      for (const text of Object.values(texts)) expect(text.length).toBeGreaterThan(0);
    }
  });
  it("follow the phone's first language that we speak", () => {
    expect(languageFor(["fr-FR", "ca-ES", "es"])).toBe("ca");
    expect(languageFor(["ja"])).toBe("en");
  });
});
