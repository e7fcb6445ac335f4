/** A length in metres; a pixel count is not one. */
export type Metres = number & { readonly unit: "m" };
/** A length on the screen, in CSS pixels. */
export type Pixels = number & { readonly unit: "px" };
/** An angle, counter-clockwise. */
export type Radians = number & { readonly unit: "rad" };
export type Milliseconds = number & { readonly unit: "ms" };

export type PointInMap = { readonly x: Metres; readonly y: Metres };
/** From the upper left corner of the map's canvas, y downwards. */
export type PointOnScreen = { readonly x: Pixels; readonly y: Pixels };

export const metres = (value: number): Metres => value as Metres;
export const pixels = (value: number): Pixels => value as Pixels;
export const radians = (value: number): Radians => value as Radians;
export const milliseconds = (value: number): Milliseconds => value as Milliseconds;

export const pointInMap = (x: number, y: number): PointInMap => ({ x: metres(x), y: metres(y) });
export const pointOnScreen = (x: number, y: number): PointOnScreen => ({ x: pixels(x), y: pixels(y) });
