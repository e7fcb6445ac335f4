// Keeps the page itself, so that it opens without a link and says that there is none. Data is never kept.
const kCache = "tandem-page";

self.addEventListener("install", (event) => {
  event.waitUntil(
    caches.open(kCache).then(async (cache) => {
      const page = await fetch("/", { cache: "no-store" });
      const files = [...(await page.clone().text()).matchAll(/(?:src|href)="(\/[^"]+)"/g)].map((found) => found[1]);
      await cache.put("/", page);
      await cache.addAll(files);
    }),
  );
});

self.addEventListener("activate", (event) => event.waitUntil(self.clients.claim()));

/** The network's answer, kept for when there is none. A search that runs is never interrupted by a newer page. */
async function answer(request) {
  const url = new URL(request.url);
  const key = request.mode === "navigate" ? "/" : url.pathname;
  const cache = await caches.open(kCache);
  if (url.pathname.startsWith("/assets/")) {
    const kept = await cache.match(key);
    if (kept !== undefined) return kept;
  }
  try {
    const response = await fetch(request);
    if (response.ok) await cache.put(key, response.clone());
    return response;
  } catch (error) {
    const kept = await cache.match(key);
    if (kept !== undefined) return kept;
    throw error;
  }
}

self.addEventListener("fetch", (event) => {
  const url = new URL(event.request.url);
  if (event.request.method === "GET" && url.origin === self.location.origin && url.pathname !== "/ws") {
    event.respondWith(answer(event.request));
  }
});
