import type { Language } from "./texts";

/**
 * What services of the team say in English, in the other languages; `#` stands for a number, `@` for a name, in the
 * same order. A sentence that is not here is shown as it came.
 */
const kReasons: readonly { readonly en: string; readonly es: string; readonly ca: string }[] = [
  { en: "outside the map", es: "fuera del mapa", ca: "fora del mapa" },
  {
    en: "too old, it waited for the connection",
    es: "demasiado antiguo, esperaba la conexión",
    ca: "massa antic, esperava la connexió",
  },
  { en: "hold for one second", es: "mantén un segundo", ca: "mantén un segon" },
  { en: "too many at once", es: "demasiados a la vez", ca: "massa de cop" },
  { en: "only before the search starts", es: "solo antes de empezar la búsqueda", ca: "només abans de la cerca" },
  {
    en: "this phone may only look, and stop the robot",
    es: "este teléfono solo puede mirar y parar el robot",
    ca: "aquest telèfon només pot mirar i aturar el robot",
  },
  {
    en: "there is no robot in this search",
    es: "no hay robot en esta búsqueda",
    ca: "no hi ha robot en aquesta cerca",
  },
  { en: "the search has not begun", es: "la búsqueda no ha empezado", ca: "la cerca no ha començat" },
  { en: "the search is over", es: "la búsqueda ha terminado", ca: "la cerca s'ha acabat" },
  { en: "no search is running", es: "no hay ninguna búsqueda en marcha", ca: "no hi ha cap cerca en marxa" },
  { en: "the map is not known yet", es: "aún no se conoce el mapa", ca: "encara no es coneix el mapa" },
  {
    en: "there is no floor to stand on near that place",
    es: "cerca de ahí no hay suelo donde estar",
    ca: "a prop d'allà no hi ha terra on estar",
  },
  {
    en: "there is no floor to pass over there",
    es: "por ahí no hay suelo por donde pasar",
    ca: "per allà no hi ha terra per on passar",
  },
  { en: "nothing is searched there", es: "ahí no se busca nada", ca: "allà no es cerca res" },
  { en: "nothing of this id is drawn", es: "eso ya no está dibujado", ca: "això ja no està dibuixat" },
  { en: "the place has no end", es: "el lugar no tiene fin", ca: "el lloc no té fi" },
  { en: "@ stands there", es: "@ está ahí", ca: "@ és allà" },
  {
    en: "@ would not get anywhere any more",
    es: "@ ya no podría ir a ningún sitio",
    ca: "@ ja no podria anar enlloc",
  },
  { en: "no way leads @ through there", es: "ningún camino lleva a @ por ahí", ca: "cap camí porta @ per allà" },
  { en: "nobody knows where @ is", es: "nadie sabe dónde está @", ca: "ningú sap on és @" },
  { en: "the robot stays behind already", es: "el robot ya va detrás", ca: "el robot ja va darrere" },
  {
    en: "too old: the person has walked on",
    es: "demasiado antiguo: la persona ha seguido andando",
    ca: "massa antic: la persona ha continuat caminant",
  },
  { en: "no answer from @", es: "@ no responde", ca: "@ no respon" },
  {
    en: "The robot has searched # m² that you have not: look where the map is purple.",
    es: "El robot ha buscado # m² que tú no: mira donde el mapa es morado.",
    ca: "El robot ha buscat # m² que tu no: mira on el mapa és lila.",
  },
  {
    en: "It is known better where the object may be: look where the map is purple.",
    es: "Se sabe mejor dónde puede estar el objeto: mira donde el mapa es morado.",
    ca: "Se sap millor on pot ser l'objecte: mira on el mapa és lila.",
  },
  {
    en: "@ has drawn a place to keep out of, # m ahead of you.",
    es: "@ ha dibujado un lugar que evitar, # m delante de ti.",
    ca: "@ ha dibuixat un lloc a evitar, # m davant teu.",
  },
  { en: "hold the button longer", es: "mantén más tiempo el botón", ca: "mantén més estona el botó" },
  { en: "nothing to resume", es: "no hay nada que continuar", ca: "no hi ha res a continuar" },
];

const patterns = kReasons.map((one) => {
  const escaped = one.en.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
  return { ...one, pattern: new RegExp(`^${escaped.replace(/#/g, "([\\d.,]+)").replace(/@/g, "(\\S+)")}$`) };
});

/** `sentence` in `language`. */
export function reasonIn(language: Language, sentence: string): string {
  if (language === "en") return sentence;
  for (const one of patterns) {
    const found = one.pattern.exec(sentence);
    if (found === null) continue;
    let group = 0;
    return one[language].replace(/[#@]/g, () => found[(group += 1)] ?? "");
  }
  return sentence;
}
