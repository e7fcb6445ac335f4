// Everything the views show, and everything a person can do.
export * from "./store/drawing";
export * from "./store/link";
export * from "./store/look";
export * from "./store/reminding";
export * from "./store/settings";
export * from "./store/signals";
export * from "./store/wishes";
