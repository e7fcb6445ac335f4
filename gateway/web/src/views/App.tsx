import { useEffect } from "preact/hooks";
import { pair } from "../net/pairing";
import * as store from "../store";
import { type Language, kLanguages } from "../texts";
import { Search } from "./Search";

export function App() {
  useEffect(() => void begin(), []);
  useEffect(() => {
    document.documentElement.lang = store.language.value;
  }, [store.language.value]);
  return store.screen.value === "search" ? <Search /> : <Welcome />;
}

/** Pairs with the link's token; without one the cookie of an earlier pairing may still be good. */
async function begin(): Promise<void> {
  const result = await pair();
  if (result === "paired" || result === "no_link") {
    store.screen.value = "start";
    store.connect();
  } else {
    store.screen.value = result;
  }
}

/** Before the search: what is going on, and the tap that browsers want before they vibrate or keep the screen on. */
function Welcome() {
  const texts = store.t.value;
  const messages = {
    pairing: texts.pairing,
    start: texts.startHint,
    search: "",
    no_link: texts.pairNoLink,
    refused: texts.pairRefused,
    locked: texts.pairLocked,
    unreachable: texts.pairUnreachable,
    moved: texts.moved,
  };
  const screen = store.screen.value;
  return (
    <main class="welcome">
      <img src="/icon.svg" alt="" width="112" height="112" />
      <h1>{texts.title}</h1>
      <p role="status">{messages[screen]}</p>
      {screen === "start" && (
        <button type="button" class="primary" onClick={start}>
          {texts.start}
        </button>
      )}
      <Languages />
    </main>
  );
}

function start(): void {
  store.screen.value = "search";
  keepScreenOn();
  document.addEventListener("visibilitychange", keepScreenOn);
}

function keepScreenOn(): void {
  if (document.hidden || !("wakeLock" in navigator)) return;
  navigator.wakeLock.request("screen").catch(() => undefined); // an empty battery may refuse; the search goes on
}

const kLanguageNames: Record<Language, string> = { en: "English", es: "Español", ca: "Català" };

function Languages() {
  return (
    <fieldset class="languages">
      <legend>{store.t.value.language}</legend>
      {(["en", "es", "ca"] as const satisfies readonly (keyof typeof kLanguages)[]).map((one) => (
        <button
          type="button"
          key={one}
          lang={one}
          aria-pressed={store.language.value === one}
          onClick={() => (store.language.value = one)}
        >
          {kLanguageNames[one]}
        </button>
      ))}
    </fieldset>
  );
}
