export type PairingResult = "paired" | "no_link" | "refused" | "locked" | "unreachable";

/** The token in the page's fragment, `#t=TOKEN&fp=...`; undefined when the page was opened without one. */
export function tokenIn(fragment: string): string | undefined {
  return new URLSearchParams(fragment.replace(/^#/, "")).get("t") ?? undefined;
}

/** Trades the link's token for the session cookie, and takes the token out of the address bar. */
export async function pair(): Promise<PairingResult> {
  const token = tokenIn(location.hash);
  if (token === undefined) return "no_link";
  history.replaceState(undefined, "", "/");
  try {
    const response = await fetch("/api/pair", {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify({ token }),
    });
    if (response.ok) return "paired";
    return response.status === 429 ? "locked" : "refused";
  } catch {
    return "unreachable";
  }
}
