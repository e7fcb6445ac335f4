import { MapCanvas } from "./MapCanvas";
import { MapButtons, UndoChip } from "./MapButtons";
import { StatusStrip } from "./StatusStrip";
import { StopButton } from "./StopButton";
import { ToastStrip } from "./ToastStrip";
import { Tools } from "./Tools";
import * as store from "../store";

/** The screen of docs/phone.md: strip, map, toast strip, tools, Replan; STOP above everything. */
export function Search() {
  return (
    <div class="search">
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
        <MapButtons />
        <UndoChip />
      </main>
      <ToastStrip />
      <Tools />
      <StopButton />
    </div>
  );
}
