import type { Belief, Episode, GridMap, Plan, Point, Replay, Stand } from "./data";
import { element, number, percent } from "./elements";
import { colourOfRole, kFindColour, kHumanColour, kRobotColour, wordsOfRole } from "./roles";

const kMargin_m = 0.5;
const kTrail_s = 15;
const kRates = [1, 2, 4, 8, 16];
const kPressShown_s = 3;

/** The last of `list` at or before `t`; what `of` gives rises along the list. */
function lastBy<Item>(list: Item[], t: number, of: (item: Item) => number): Item | undefined {
  let low = 0;
  let high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    const item = list[middle];
    if (item !== undefined && of(item) <= t) low = middle + 1;
    else high = middle;
  }
  return low > 0 ? list[low - 1] : undefined;
}

function between(stands: Stand[], t: number): Stand | undefined {
  const before = lastBy(stands, t, (stand) => stand[0]);
  if (before === undefined) return stands[0];
  const after = stands[stands.indexOf(before) + 1];
  if (after === undefined || after[0] === before[0]) return before;
  const part = (t - before[0]) / (after[0] - before[0]);
  const turn = Math.atan2(Math.sin(after[3] - before[3]), Math.cos(after[3] - before[3]));
  return [t, before[1] + part * (after[1] - before[1]), before[2] + part * (after[2] - before[2]), before[3] + part * turn];
}

/** A picture of `width` x `height` pixels, a row of the grid a row of it, the uppermost first. */
function raster(width: number, height: number, colour: (index: number) => [number, number, number, number]): HTMLCanvasElement {
  const canvas = element("canvas", { width: String(width), height: String(height) });
  const context = canvas.getContext("2d");
  if (context === null) return canvas;
  const image = context.createImageData(width, height);
  for (let row = 0; row < height; row += 1) {
    for (let column = 0; column < width; column += 1) {
      image.data.set(colour((height - 1 - row) * width + column), 4 * (row * width + column));
    }
  }
  context.putImageData(image, 0, 0);
  return canvas;
}

const mapRaster = (map: GridMap) =>
  raster(map.width, map.height, (index) => {
    const cell = map.cells[index];
    return cell === "#" ? [40, 44, 52, 255] : cell === "." ? [250, 250, 248, 255] : [190, 192, 196, 255];
  });

const beliefRaster = (belief: Belief) =>
  raster(belief.width, belief.height, (index) => {
    const cell = belief.cells[index] ?? 255;
    return cell === 255 ? [0, 0, 0, 0] : [118, 60, 200, Math.round(0.75 * cell)];
  });

/** What is drawn: the world at a moment. */
class Stage {
  readonly canvas: HTMLCanvasElement;
  private readonly map: HTMLCanvasElement;
  private readonly beliefs = new Map<Belief, HTMLCanvasElement>();
  private readonly paths = new Map<string, Record<string, Point[]>>();
  private readonly pixels_per_m: number;
  private readonly corner: Point;
  private readonly size_m: Point;

  constructor(
    private readonly replay: Replay,
    private readonly grid: GridMap,
  ) {
    this.map = mapRaster(grid);
    this.corner = [grid.map_from_grid[0] - kMargin_m, grid.map_from_grid[1] - kMargin_m];
    this.size_m = [
      grid.width * grid.resolution_m + 2 * kMargin_m,
      grid.height * grid.resolution_m + 2 * kMargin_m,
    ];
    const width = Math.min(1200, 860 * Math.min(2, globalThis.devicePixelRatio || 1));
    this.pixels_per_m = width / this.size_m[0];
    this.canvas = element("canvas", {
      class: "stage",
      width: String(Math.round(width)),
      height: String(Math.round(this.size_m[1] * this.pixels_per_m)),
      role: "img",
      "aria-label": "Map with robot, person, plan and belief",
    });
    for (const plan of replay.plans) if (plan.paths !== undefined) this.paths.set(plan.id, plan.paths);
  }

  draw(t: number): void {
    const context = this.canvas.getContext("2d");
    if (context === null) return;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = "#bebfc4";
    context.fillRect(0, 0, this.canvas.width, this.canvas.height);
    const scale = this.pixels_per_m;
    context.setTransform(scale, 0, 0, -scale, -this.corner[0] * scale, this.canvas.height + this.corner[1] * scale);
    context.imageSmoothingEnabled = false;
    this.grid_picture(context, this.map, this.grid.map_from_grid, this.grid.resolution_m);
    const belief = lastBy(this.replay.beliefs, t, (one) => one.t);
    if (belief !== undefined) {
      this.grid_picture(context, this.beliefRasterOf(belief), [...belief.origin, 0], belief.resolution_m);
    }
    this.plan(context, t);
    this.trail(context, this.replay.robot, t, kRobotColour);
    this.trail(context, this.replay.human, t, kHumanColour);
    for (const point of lastBy(this.replay.passers_by, t, (one) => one[0])?.[1] ?? []) this.disc(context, point, 0.22, "#8a8f98");
    this.presses(context, t);
    if (this.replay.object !== undefined) this.object(context, this.replay.object);
    this.body(context, between(this.replay.human, t), 0.25, kHumanColour);
    this.body(context, between(this.replay.robot, t), 0.35, kRobotColour);
  }

  private beliefRasterOf(belief: Belief): HTMLCanvasElement {
    let made = this.beliefs.get(belief);
    if (made === undefined) {
      made = beliefRaster(belief);
      this.beliefs.set(belief, made);
    }
    return made;
  }

  /** `picture` with its lower left corner at a pose of the map, its first row the uppermost. */
  private grid_picture(context: CanvasRenderingContext2D, picture: HTMLCanvasElement, [x, y, heading]: number[], resolution_m: number): void {
    context.save();
    context.translate(x ?? 0, y ?? 0);
    context.rotate(heading ?? 0);
    context.scale(resolution_m, -resolution_m);
    context.drawImage(picture, 0, -picture.height);
    context.restore();
  }

  private line(context: CanvasRenderingContext2D, points: Point[]): void {
    context.beginPath();
    points.forEach(([x, y], i) => (i === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
    context.stroke();
  }

  private plan(context: CanvasRenderingContext2D, t: number): void {
    const plan = lastBy(this.replay.plans, t, (one) => one.t);
    if (plan === undefined || plan.state === "rejected" || plan.state === "superseded") return;
    for (const [agent, points] of Object.entries(this.paths.get(plan.id) ?? {})) {
      context.setLineDash(plan.state === "accepted" ? [] : [0.3, 0.2]);
      for (const [width, colour] of [[0.24, "#fff"], [0.12, agent === this.replay.robot_name ? kRobotColour : kHumanColour]] as const) {
        context.lineWidth = width;
        context.strokeStyle = colour;
        this.line(context, points);
      }
    }
    context.setLineDash([]);
  }

  private trail(context: CanvasRenderingContext2D, stands: Stand[], t: number, colour: string): void {
    const points = stands.filter(([at]) => at <= t && at > t - kTrail_s).map(([, x, y]): Point => [x, y]);
    context.strokeStyle = colour;
    context.lineWidth = 0.22;
    context.globalAlpha = 0.3;
    this.line(context, points);
    context.globalAlpha = 1;
  }

  private presses(context: CanvasRenderingContext2D, t: number): void {
    for (const press of this.replay.presses) {
      if (press.at === undefined || press.t > t || press.t < t - kPressShown_s) continue;
      context.strokeStyle = press.kind === "robot_goal" ? kRobotColour : kHumanColour;
      context.lineWidth = 0.08;
      context.beginPath();
      context.arc(press.at[0], press.at[1], 0.45, 0, 2 * Math.PI);
      context.stroke();
    }
  }

  private object(context: CanvasRenderingContext2D, [x, y]: Point): void {
    context.fillStyle = kFindColour;
    context.strokeStyle = "#6b5600";
    context.lineWidth = 0.06;
    context.beginPath();
    for (let i = 0; i < 10; i += 1) {
      const radius = i % 2 === 0 ? 0.42 : 0.18;
      const angle = Math.PI / 2 + (i * Math.PI) / 5;
      context.lineTo(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
    }
    context.closePath();
    context.fill();
    context.stroke();
  }

  private disc(context: CanvasRenderingContext2D, [x, y]: Point, radius: number, colour: string): void {
    context.fillStyle = colour;
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.fill();
  }

  private body(context: CanvasRenderingContext2D, stand: Stand | undefined, radius: number, colour: string): void {
    if (stand === undefined) return;
    const [, x, y, heading] = stand;
    this.disc(context, [x, y], radius, colour);
    context.strokeStyle = "#fff";
    context.lineWidth = 0.09;
    this.line(context, [[x, y], [x + radius * Math.cos(heading), y + radius * Math.sin(heading)]]);
  }
}

const kPressWords: Record<string, string> = {
  my_pose: "My pose", my_goal: "My goal", robot_goal: "Robot goal", replan: "Replan",
  clear_my_goal: "My goal withdrawn", clear_robot_goal: "Robot goal withdrawn",
};

/** A strip below the slider: roles as colour, presses as marks, stops as bars. */
function strip(episode: Episode, replay: Replay, begin_s: number): SVGSVGElement {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  const length = Math.max(0.1, episode.duration_s - begin_s);
  svg.setAttribute("viewBox", "0 0 1000 34");
  svg.setAttribute("preserveAspectRatio", "none");
  svg.setAttribute("class", "strip");
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", "Roles, presses on the phone and stops over time");
  const mark = (from: number, to: number, y: number, height: number, colour: string, words: string) => {
    const rect = document.createElementNS("http://www.w3.org/2000/svg", "rect");
    const place = {
      x: (1000 * (from - begin_s)) / length, y, width: Math.max(1.5, (1000 * (to - from)) / length), height, fill: colour,
    };
    for (const [name, value] of Object.entries(place)) rect.setAttribute(name, String(value));
    const title = document.createElementNS("http://www.w3.org/2000/svg", "title");
    title.textContent = words;
    rect.append(title);
    svg.append(rect);
  };
  for (const [from, to, role] of episode.roles) mark(from, to, 0, 10, colourOfRole(role), wordsOfRole(role));
  for (const press of replay.presses) {
    mark(press.t, press.t, 12, 10, press.kind === "replan" ? "#4269d0" : kHumanColour, `${kPressWords[press.kind] ?? press.kind} at ${number(press.t)} s`);
  }
  replay.stops.forEach(([from, reasons], i) => {
    if (reasons.length === 0) return;
    mark(Math.max(begin_s, from), Math.min(replay.stops[i + 1]?.[0] ?? episode.duration_s, episode.duration_s), 24, 10, "#d03a3a", reasons.join(", "));
  });
  return svg;
}

function momentWords(episode: Episode, replay: Replay, t: number): string {
  const explored = lastBy(episode.explored, t, (line) => line[0]);
  const plan: Plan | undefined = lastBy(replay.plans, t, (one) => one.t);
  const press = lastBy(replay.presses, t, (one) => one.t);
  const stop = lastBy(replay.stops, t, (one) => one[0])?.[1] ?? [];
  const parts = [`${number(t)} s`];
  if (explored !== undefined) parts.push(`explored ${percent(explored[2])}`);
  if (plan !== undefined) parts.push(`plan ${plan.state}: ${wordsOfRole(plan.role)}`);
  if (press !== undefined && t - press.t < kPressShown_s) parts.push(`pressed ${kPressWords[press.kind] ?? press.kind}`);
  if (stop.length > 0) parts.push(`stopped: ${stop.join(", ")}`);
  if (t >= episode.duration_s) parts.push(episode.outcome === "found" ? `found by ${episode.found_by}` : "not found");
  return parts.join(" · ");
}

/** An episode to play, pause and drag through. */
export function scrubber(episode: Episode, replay: Replay, map: GridMap): HTMLElement {
  const stage = new Stage(replay, map);
  const begin_s = Math.min(0, replay.robot[0]?.[0] ?? 0);
  const slider = element("input", {
    type: "range", min: String(begin_s), max: String(episode.duration_s), step: "0.1", value: String(begin_s), "aria-label": "Time in s",
  });
  const play = element("button", { type: "button", class: "play" }, "Play");
  const rate = element("select", { "aria-label": "Speed" }, ...kRates.map((value) => element("option", { value: String(value) }, `${value}×`)));
  rate.value = "4";
  const words = element("p", { class: "moment", "aria-live": "off" });
  let playing = false;
  let last_ms = 0;

  const show = () => {
    const t = Number(slider.value);
    stage.draw(t);
    words.textContent = momentWords(episode, replay, t);
  };
  const stop = () => {
    playing = false;
    play.textContent = "Play";
  };
  const tick = (now_ms: number) => {
    if (!playing) return;
    const t = Number(slider.value) + ((now_ms - last_ms) / 1000) * Number(rate.value);
    last_ms = now_ms;
    slider.value = String(Math.min(t, episode.duration_s));
    show();
    if (t >= episode.duration_s) stop();
    else requestAnimationFrame(tick);
  };
  play.addEventListener("click", () => {
    if (playing) {
      stop();
      return;
    }
    if (Number(slider.value) >= episode.duration_s) slider.value = String(begin_s);
    playing = true;
    play.textContent = "Pause";
    last_ms = performance.now();
    requestAnimationFrame(tick);
  });
  slider.addEventListener("input", show);
  show();
  return element(
    "div", { class: "scrubber" },
    stage.canvas,
    element("div", { class: "controls" }, play, slider, rate),
    strip(episode, replay, begin_s) as unknown as HTMLElement,
    words,
    element("p", { class: "legend" },
      ...([[kRobotColour, "robot"], [kHumanColour, "person"], ["#8a8f98", "passers-by"], ["#763cc8", "where it may be"], [kFindColour, "where it is"]] as const)
        .flatMap(([colour, name]) => [element("span", { class: "key", style: `background:${colour}` }), ` ${name}  `]),
    ),
  );
}
