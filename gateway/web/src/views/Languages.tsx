import * as store from "../store";
import type { Language } from "../texts";
import { Choice } from "./Choice";

const kNames: Record<Language, string> = { en: "English", es: "Español", ca: "Català" };

export function Languages() {
  return (
    <Choice
      legend={store.t.value.language}
      words={["en", "es", "ca"] as const}
      chosen={store.language.value}
      text={(word) => kNames[word]}
      lang={(word) => word}
      choose={(word) => (store.language.value = word)}
    />
  );
}
