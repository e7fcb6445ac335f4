import { describe, expect, it } from "vitest";
import { reasonIn } from "./reasons";

describe("reasons", () => {
  it("are told in the person's language, names and numbers kept", () => {
    expect(reasonIn("es", "outside the map")).toBe("fuera del mapa");
    expect(reasonIn("ca", "person1 stands there")).toBe("person1 és allà");
    expect(reasonIn("es", "The robot has searched 34 m² that you have not: look where the map is purple.")).toBe(
      "El robot ha buscado 34 m² que tú no: mira donde el mapa es morado.",
    );
  });
  it("are shown as they came when nobody has translated them", () => {
    expect(reasonIn("es", "the moon is full")).toBe("the moon is full");
    expect(reasonIn("en", "outside the map")).toBe("outside the map");
  });
});
