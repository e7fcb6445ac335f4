import * as v from "valibot";

/** A value that was understood, or why not. Nothing here throws. */
export type Parsed<T> = { readonly ok: true; readonly value: T } | { readonly ok: false; readonly reason: string };

const kFar = 1e5;
const kLong = 1e12;
export const text = (min: number, max: number) => v.pipe(v.string(), v.minLength(min), v.maxLength(max));
export const range = (min: number, max: number) => v.pipe(v.number(), v.finite(), v.minValue(min), v.maxValue(max));
export const count = (min: number, max: number) => v.pipe(v.number(), v.safeInteger(), v.minValue(min), v.maxValue(max));
export const coordinate = range(-kFar, kFar);
export const heading = range(-6.3, 6.3);
export const seconds = range(0, kLong);
export const duration = range(0, kLong);
export const share = range(0, 1);
export const sequence = count(0, Number.MAX_SAFE_INTEGER);
export const positive = count(1, Number.MAX_SAFE_INTEGER);
export const client = v.pipe(v.string(), v.regex(/^[0-9A-Za-z-]{8,64}$/));

export const point = v.strictTuple([coordinate, coordinate]);

/** Keys that mean something to JavaScript itself are never ours. */
function refuseReserved(key: string, value: unknown): unknown {
  if (key === "__proto__" || key === "constructor" || key === "prototype") throw new SyntaxError(key);
  return value;
}

/** Parses `json` by `schema`. */
export function parsed<Schema extends v.GenericSchema>(schema: Schema, json: string): Parsed<v.InferOutput<Schema>> {
  let value: unknown;
  try {
    value = JSON.parse(json, refuseReserved);
  } catch {
    return { ok: false, reason: "not JSON, or a reserved key" };
  }
  const result = v.safeParse(schema, value);
  return result.success
    ? { ok: true, value: result.output }
    : { ok: false, reason: result.issues[0]?.message ?? "not a message" };
}
