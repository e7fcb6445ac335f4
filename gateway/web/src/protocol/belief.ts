import type { Parsed } from "./fields";

/** The belief grid: 0 to 254 is the share of the peak, 255 is not searched. */
export type BeliefGrid = {
  readonly width: number;
  readonly height: number;
  readonly resolution: number;
  readonly x: number;
  readonly y: number;
  readonly revision: number;
  readonly cells: Uint8Array;
};

const kHead = 22;

/** Parses the one binary frame of the protocol (gateway/protocol/belief_frame.hpp). */
export function parseBelief(frame: ArrayBuffer): Parsed<BeliefGrid> {
  if (frame.byteLength < kHead) return { ok: false, reason: "too short" };
  const view = new DataView(frame);
  if (view.getUint8(0) !== 1 || view.getUint8(1) !== 1) return { ok: false, reason: "another kind of frame" };
  const width = view.getUint16(2, true);
  const height = view.getUint16(4, true);
  if (frame.byteLength !== kHead + width * height) return { ok: false, reason: "the cells do not fill the grid" };
  const [resolution, x, y] = [view.getFloat32(6, true), view.getFloat32(10, true), view.getFloat32(14, true)];
  if (!(resolution > 0) || !Number.isFinite(x) || !Number.isFinite(y)) return { ok: false, reason: "no finite place" };
  const revision = view.getUint32(18, true);
  return { ok: true, value: { width, height, resolution, x, y, revision, cells: new Uint8Array(frame, kHead) } };
}
