import type { BeliefGrid } from "../protocol/belief";
import type { MapMessage } from "../protocol/parse";
import type { Palette } from "./palette";

/** Where the object may be: purple, more opaque where it is likelier; on a dark floor lighter. */
const kHeat = [123, 50, 148] as const;
const kHeatInTheDark = [200, 130, 235] as const;
/** Where it hardly is any more: green stripes. */
const kSearched = [0, 158, 115] as const;
/** A cell that holds less than this share of the likeliest one is as good as searched. */
const kHardly = 0.1 * 254;

function painted(width: number, height: number, paint: (data: Uint8ClampedArray) => void): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d");
  if (context !== null) {
    const image = context.createImageData(width, height);
    paint(image.data);
    context.putImageData(image, 0, 0);
  }
  return canvas;
}

/** Walls as a picture with its first row on top; painted once for each map. */
export function pictureOfMap(map: MapMessage, palette: Palette): HTMLCanvasElement {
  return painted(map.width, map.height, (data) => {
    let cell = 0;
    for (const [count, value] of map.runs) {
      const colour = value === 0 ? palette.free : value === 100 ? palette.occupied : palette.unknown;
      for (const end = cell + count; cell < end; cell += 1) {
        const row = map.height - 1 - Math.floor(cell / map.width);
        data.set(colour, 4 * (row * map.width + (cell % map.width)));
      }
    }
  });
}

/** The belief as colour: likely places, or those where looking is hardly worth it any more. */
export function pictureOfBelief(grid: BeliefGrid, what: "belief" | "explored", dark: boolean): HTMLCanvasElement {
  const heat = dark ? kHeatInTheDark : kHeat;
  return painted(grid.width, grid.height, (data) => {
    for (let cell = 0; cell < grid.cells.length; cell += 1) {
      const value = grid.cells[cell] ?? 255;
      if (value === 255) continue;
      const row = grid.height - 1 - Math.floor(cell / grid.width);
      const column = cell % grid.width;
      const at = 4 * (row * grid.width + column);
      if (what === "belief") {
        data.set(heat, at);
        data[at + 3] = Math.round((dark ? 160 : 110) * (value / 254) ** 0.7);
      } else if (value < kHardly) {
        data.set(kSearched, at);
        data[at + 3] = (row + column) % 3 === 0 ? 150 : 70;
      }
    }
  });
}
