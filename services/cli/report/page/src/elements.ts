type Child = Node | string;

/** An element; words are set as text, never as HTML. */
export function element<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Record<string, string> = {},
  ...children: Child[]
): HTMLElementTagNameMap[Tag] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

export function table(head: string[], rows: Child[][], attributes: Record<string, string> = {}): HTMLElement {
  const headRow = element("tr", {}, ...head.map((words) => element("th", { scope: "col" }, words)));
  const body = rows.map((cells) =>
    element("tr", {}, ...cells.map((cell, i) => (i === 0 ? element("th", { scope: "row" }, cell) : element("td", {}, cell)))),
  );
  const made = element("table", attributes, element("thead", {}, headRow), element("tbody", {}, ...body));
  return element("div", { class: "scrolled" }, made);
}

export function section(title: string, words: string, ...children: Child[]): HTMLElement {
  return element("section", {}, element("h2", {}, title), element("p", { class: "words" }, words), ...children);
}

/** A number as people read it; a dash for what is not known. */
export function number(value: number | null | undefined, digits = 1): string {
  return value === null || value === undefined ? "–" : value.toFixed(digits);
}

export function percent(share: number | null | undefined, digits = 0): string {
  return share === null || share === undefined ? "–" : `${(100 * share).toFixed(digits)} %`;
}

export function pValue(p: number): string {
  return p < 0.001 ? "< 0.001" : p.toFixed(3);
}

export function stars(p: number): string {
  if (p < 0.001) return "***";
  if (p < 0.01) return "**";
  return p < 0.05 ? "*" : "";
}
