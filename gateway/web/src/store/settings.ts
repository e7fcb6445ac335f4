import { computed, effect, signal } from "@preact/signals";
import { type Language, kLanguages, languageFor, textsOf } from "../texts";
import { kept } from "./kept";

export type Theme = "light" | "dark";
export type Hand = "left" | "right";

const languageKept = kept("language");
const themeKept = kept("theme");
const handKept = kept("hand");

const isLanguage = (word: string | undefined): word is Language => word !== undefined && word in kLanguages;
const savedLanguage = languageKept.load();

export const language = signal<Language>(
  isLanguage(savedLanguage) ? savedLanguage : languageFor(navigator.languages),
);
/** Light is for the sun: it is what a phone begins with, whatever it wears else. */
export const theme = signal<Theme>(themeKept.load() === "dark" ? "dark" : "light");
export const hand = signal<Hand>(handKept.load() === "left" ? "left" : "right");
export const t = computed(() => textsOf(language.value));

effect(() => {
  languageKept.save(language.value);
  document.documentElement.lang = language.value;
});
effect(() => {
  themeKept.save(theme.value);
  document.documentElement.dataset["theme"] = theme.value;
});
effect(() => {
  handKept.save(hand.value);
  document.documentElement.dataset["hand"] = hand.value;
});
