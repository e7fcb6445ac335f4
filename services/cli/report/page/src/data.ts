/** What report_json.cpp writes. Times in s since the search began, lengths in m, shares in [0, 1]. */
export type Line3 = [time: number, robot: number, all: number];

export interface Episode {
  name: string;
  code: string;
  fields: Record<string, string>;
  outcome: string;
  found_by: string;
  duration_s: number;
  first_expected_s: number | null;
  first_lower_bound_s: number | null;
  round_trip_s: number | null;
  reminder_effect: number | null;
  teammate_time_to_collision_s: number | null;
  values: Record<string, number | null>;
  stops: Record<string, { times: number; s: number }>;
  explored: Line3[];
  roles: [from: number, to: number, role: string][];
  presses: [time: number, kind: string][];
  gaps: string[];
}

export interface Group {
  name: string;
  episodes: number[];
  found: number;
  my_pose: {
    until_s: number | null;
    episodes: number;
    per_min: number;
    deviation: number;
    within: number;
    with_messages: number;
  }[];
  matching_threshold_s: number;
  explored: [time: number, ongoing: number, robot: number, all: number][];
  roles: [time: number, ongoing: number, inRole: number[]][];
}

export interface Pair {
  a: string;
  b: string;
  p: number;
  p_holm: number;
  pairs: number;
  g: number;
  low: number;
  high: number;
}

export interface Comparison {
  measure: string;
  groups: { n: number; mean: number; deviation: number; median: number }[];
  anova: { f: number | null; between: number; within: number; p: number; eta_squared: number };
  pairs: Pair[];
}

export interface GridMap {
  width: number;
  height: number;
  resolution_m: number;
  map_from_grid: [x: number, y: number, heading: number];
  /** Row by row from the lower left: "." free, "#" occupied, "?" unknown. */
  cells: string;
}

export type Point = [x: number, y: number];
export type Stand = [time: number, x: number, y: number, heading: number];

export interface Plan {
  t: number;
  id: string;
  state: "proposed" | "accepted" | "rejected" | "superseded";
  role: string;
  expected_s: number | null;
  /** By agent; where the plan is told for the first time. */
  paths?: Record<string, Point[]>;
}

export interface Belief {
  t: number;
  width: number;
  height: number;
  resolution_m: number;
  origin: Point;
  /** 0 to 254: share of the peak; 255: not searched. */
  cells: number[];
}

export interface Replay {
  map: number;
  robot: Stand[];
  human: Stand[];
  robot_name: string;
  human_name: string;
  plans: Plan[];
  beliefs: Belief[];
  presses: { t: number; kind: string; at?: Point }[];
  passers_by: [time: number, points: Point[]][];
  stops: [time: number, reasons: string[]][];
  object?: Point;
}

export interface Report {
  title: string;
  by: string;
  pair: string;
  threshold_s: number;
  baseline: string;
  step_s: number;
  measures: { name: string; unit: string; words: string }[];
  episodes: Episode[];
  groups: Group[];
  comparisons: Comparison[];
  questions: Comparison[];
  maps?: GridMap[];
  replays?: Replay[];
}

/** The report that stands, deflated and in base64, in the page. */
export async function loadReport(): Promise<Report> {
  const packed = document.getElementById("data")?.textContent?.trim() ?? "";
  const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return JSON.parse(await new Response(unpacked).text()) as Report;
}
