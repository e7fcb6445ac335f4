import * as store from "../store";

function recentre(): void {
  const view = store.view.value;
  if (view !== undefined) store.showEverything(view.width, view.height);
}

/** A row along the lower edge of the map, in reach of a thumb and off the map that fits above it. */
export function MapButtons() {
  const texts = store.t.value;
  const needle = (-180 / Math.PI) * (store.view.value?.turn ?? 0);
  const layers = { belief: texts.layerBelief, explored: texts.layerExplored, none: texts.layerNone };
  return (
    <div class="map-buttons">
      <button
        type="button"
        data-button="turn"
        aria-label={store.headingUp.value || Math.abs(needle) > 0.5 ? texts.north : texts.turnMap}
        aria-pressed={store.headingUp.value}
        onClick={store.turnMap}
      >
        <svg viewBox="0 0 24 24" aria-hidden="true">
          <g transform={`rotate(${needle} 12 12)`}>
            <path d="M12 0l5 12H7z" class="ink-red" />
            <path d="M12 24l-5-12h10z" />
          </g>
        </svg>
      </button>
      {!store.isBetweenPeople.value && (
        <button
          type="button"
          data-button="layer"
          data-layer={store.layer.value}
          aria-label={layers[store.layer.value]}
          onClick={store.nextLayer}
        >
          <svg viewBox="0 0 24 24" aria-hidden="true">
            <path d="M12 3l9 5-9 5-9-5z" class={`layer ${store.layer.value}`} />
            <path d="M3 12l9 5 9-5M3 16l9 5 9-5" class="line" />
          </svg>
        </button>
      )}
      <button type="button" data-button="recentre" aria-label={texts.recentre} onClick={recentre}>
        <svg viewBox="0 0 24 24" aria-hidden="true">
          <path d="M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5" class="line" />
          <circle cx="12" cy="12" r="3" />
        </svg>
      </button>
      <button
        type="button"
        data-button="settings"
        aria-label={texts.settings}
        onClick={() => (store.sheet.value = "settings")}
      >
        <svg viewBox="0 0 24 24" aria-hidden="true">
          <path d="M4 7h9M19 7h1M4 17h1M11 17h9" class="line" />
          <circle cx="16" cy="7" r="3" class="line" />
          <circle cx="8" cy="17" r="3" class="line" />
        </svg>
      </button>
    </div>
  );
}
