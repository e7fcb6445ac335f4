import { useEffect } from "preact/hooks";
import { pair } from "../net/pairing";
import * as store from "../store";
import { Languages } from "./Languages";
import { Search } from "./Search";

export function App() {
  useEffect(() => void begin(), []);
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
  store.allowSound();
  keepScreenOn();
  document.addEventListener("visibilitychange", keepScreenOn);
}

function keepScreenOn(): void {
  if (document.hidden || !("wakeLock" in navigator)) return;
  navigator.wakeLock.request("screen").catch(() => undefined); // an empty battery may refuse; the search goes on
}
