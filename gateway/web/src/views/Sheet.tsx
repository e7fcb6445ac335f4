import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import * as store from "../store";

/** What comes up over the tools for a moment, under STOP; Escape and *Close* take it away. */
export function Sheet(props: { title: string; name: string; children: ComponentChildren }) {
  const close = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    close.current?.focus();
    const key = (event: KeyboardEvent) => {
      if (event.key === "Escape") store.sheet.value = undefined;
    };
    document.addEventListener("keydown", key);
    return () => document.removeEventListener("keydown", key);
  }, []);
  return (
    <section class="sheet" role="dialog" aria-label={props.title} data-sheet={props.name}>
      <div class="sheet-head">
        <h2>{props.title}</h2>
        <button ref={close} type="button" class="close" onClick={() => (store.sheet.value = undefined)}>
          {store.t.value.close}
        </button>
      </div>
      <div class="sheet-body">{props.children}</div>
    </section>
  );
}
