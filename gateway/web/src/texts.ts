import { ca } from "./texts/ca";
import { type Texts, en } from "./texts/en";
import { es } from "./texts/es";

export const kLanguages = { en, es, ca } as const;
export type Language = keyof typeof kLanguages;
export type TextKey = keyof Texts;

/** The first language of the phone that we speak; English otherwise. */
export function languageFor(wanted: readonly string[]): Language {
  for (const one of wanted) {
    const short = one.slice(0, 2).toLowerCase();
    if (short === "en" || short === "es" || short === "ca") return short;
  }
  return "en";
}

export const textsOf = (language: Language): Texts => kLanguages[language];
