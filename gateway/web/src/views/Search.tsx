import * as store from "../store";
import { MapButtons } from "./MapButtons";
import { MapCanvas } from "./MapCanvas";
import { More } from "./More";
import { PopUp } from "./PopUp";
import { Settings } from "./Settings";
import { StatusStrip } from "./StatusStrip";
import { StopButton } from "./StopButton";
import { ToastStrip } from "./ToastStrip";
import { Tools } from "./Tools";

/** The screen of docs/phone.md: strip, map, toast strip, tools, Replan; STOP above everything. */
export function Search() {
  const asks = store.popupIsOpen.value;
  const session = store.session.value;
  return (
    // For the browser test: which session the page knows.
    <div class="search" data-session={`${session?.phase} ${session?.mode} ${session?.reminder.kind}`}>
      <StatusStrip />
      <main class="map">
        <h1 class="hidden">{store.t.value.title}</h1>
        <MapCanvas />
        {store.map.value === undefined && <p class="map-note">{store.t.value.waitingForMap}</p>}
        {store.isStale.value && (
          <p class="map-note stale" role="alert">
            {store.t.value.old} {Math.round(store.dataAgeMs.value / 1000)} {store.t.value.seconds}
          </p>
        )}
        {!asks && <MapButtons />}
      </main>
      <div class="panel" inert={asks}>
        <ToastStrip />
        <Tools />
      </div>
      {!asks && store.sheet.value === "settings" && <Settings />}
      {!asks && store.sheet.value === "more" && <More />}
      {asks && <PopUp />}
      {store.edgeFlashes.value && <div class="edge" aria-hidden="true" />}
      {!store.isBetweenPeople.value && <StopButton />}
    </div>
  );
}
