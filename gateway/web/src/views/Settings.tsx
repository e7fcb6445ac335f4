import * as store from "../store";
import { Choice } from "./Choice";
import { Languages } from "./Languages";
import { Sheet } from "./Sheet";

export function Settings() {
  const texts = store.t.value;
  return (
    <Sheet title={texts.settings} name="settings">
      <Languages />
      <Choice
        legend={texts.theme}
        words={["light", "dark"] as const}
        chosen={store.theme.value}
        text={(word) => texts[word]}
        choose={(word) => (store.theme.value = word)}
      />
      <Choice
        legend={texts.hand}
        words={["left", "right"] as const}
        chosen={store.hand.value}
        text={(word) => texts[word]}
        choose={(word) => (store.hand.value = word)}
      />
    </Sheet>
  );
}
