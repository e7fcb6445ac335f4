import type { Theme } from "../store/settings";

/** RGBA of each value of the map, and what lies around it. */
export type Palette = {
  readonly around: string;
  readonly free: readonly [number, number, number, number];
  readonly occupied: readonly [number, number, number, number];
  readonly unknown: readonly [number, number, number, number];
  readonly ink: string;
  readonly halo: string;
};

/** Light is for the sun, dark for the night; what is drawn on it keeps its colour, on a halo that tells it apart. */
export const kPalettes: { readonly [Name in Theme]: Palette } = {
  light: {
    around: "#dee3e8",
    free: [255, 255, 255, 255],
    occupied: [38, 42, 48, 255],
    unknown: [222, 227, 232, 255],
    ink: "#111418",
    halo: "#ffffff",
  },
  dark: {
    around: "#0c0f12",
    free: [58, 65, 73, 255],
    occupied: [160, 169, 178, 255],
    unknown: [12, 15, 18, 255],
    ink: "#f4f6f8",
    halo: "#0c0f12",
  },
};
