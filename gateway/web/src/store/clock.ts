/** Milliseconds that go on over a reload and do not follow a step of the wall clock while the page is open. */
export const now = (): number => performance.timeOrigin + performance.now();
