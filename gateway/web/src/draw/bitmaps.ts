import type { BeliefGrid } from "../protocol/belief";
import type { MapMessage } from "../protocol/parse";

/** RGBA of each value of the map. */
const kFree = [255, 255, 255, 255] as const;
const kOccupied = [38, 42, 48, 255] as const;
const kUnknown = [222, 227, 232, 255] as const;
/** Where the object may be: purple, more opaque where it is likelier. */
const kHeat = [123, 50, 148] as const;

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
export function pictureOfMap(map: MapMessage): HTMLCanvasElement {
  return painted(map.width, map.height, (data) => {
    let cell = 0;
    for (const [count, value] of map.runs) {
      const colour = value === 0 ? kFree : value === 100 ? kOccupied : kUnknown;
      for (const end = cell + count; cell < end; cell += 1) {
        const row = map.height - 1 - Math.floor(cell / map.width);
        data.set(colour, 4 * (row * map.width + (cell % map.width)));
      }
    }
  });
}

export function pictureOfBelief(grid: BeliefGrid): HTMLCanvasElement {
  return painted(grid.width, grid.height, (data) => {
    for (let cell = 0; cell < grid.cells.length; cell += 1) {
      const value = grid.cells[cell] ?? 255;
      if (value === 255 || value === 0) continue;
      const row = grid.height - 1 - Math.floor(cell / grid.width);
      const at = 4 * (row * grid.width + (cell % grid.width));
      data.set(kHeat, at);
      data[at + 3] = Math.round(110 * (value / 254) ** 0.7);
    }
  });
}
