import * as store from "../store";
import { radians } from "../units";

function recentre(): void {
  const view = store.view.value;
  if (view !== undefined) store.showEverything(view.width, view.height);
}

function turnUpright(): void {
  if (store.view.value !== undefined) store.look({ ...store.view.value, turn: radians(0) });
}

/** A row along the lower edge of the map, in reach of a thumb and off the map that fits above it. */
export function MapButtons() {
  const texts = store.t.value;
  const needle = (-180 / Math.PI) * (store.view.value?.turn ?? 0);
  const turned = store.view.value !== undefined && Math.abs(store.view.value.turn) > 0.01;
  return (
    <div class="map-buttons">
      {turned && (
        <button type="button" aria-label={texts.north} onClick={turnUpright}>
          <svg viewBox="0 0 24 24" aria-hidden="true">
            <g transform={`rotate(${needle} 12 12)`}>
              <path d="M12 0l5 12H7z" class="ink-red" />
              <path d="M12 24l-5-12h10z" />
            </g>
          </svg>
        </button>
      )}
      <button
        type="button"
        aria-label={texts.belief}
        aria-pressed={store.showBelief.value}
        onClick={() => (store.showBelief.value = !store.showBelief.value)}
      >
        <svg viewBox="0 0 24 24" aria-hidden="true">
          <path d="M12 3l9 5-9 5-9-5z" />
          <path d="M3 12l9 5 9-5M3 16l9 5 9-5" class="line" />
        </svg>
      </button>
      <button type="button" aria-label={texts.recentre} onClick={recentre}>
        <svg viewBox="0 0 24 24" aria-hidden="true">
          <path d="M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5" class="line" />
          <circle cx="12" cy="12" r="3" />
        </svg>
      </button>
    </div>
  );
}

export function UndoChip() {
  if (store.undo.value === undefined) return null;
  return (
    <button type="button" class="undo" onClick={store.undoGoal}>
      ↶ {store.t.value.undo}
    </button>
  );
}
