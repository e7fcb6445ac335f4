/** A text that survives a reload, in the phone's storage. */
export const kept = (key: string) => ({
  load: (): string | undefined => localStorage.getItem(`tandem.${key}`) ?? undefined,
  save: (text: string): void => localStorage.setItem(`tandem.${key}`, text),
});
