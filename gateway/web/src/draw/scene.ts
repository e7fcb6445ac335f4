import { type MapView, toScreen } from "../model/map_view";
import type { BeliefGrid } from "../protocol/belief";
import type { PlaceKind } from "../protocol/commands";
import type { MapMessage, Person, Plan, Source, State } from "../protocol/parse";
import { type PointInMap, type PointOnScreen, pointInMap, pointOnScreen } from "../units";
import type { Palette } from "./palette";
import * as shape from "./shapes";

/** Everything a picture of the map shows. */
export type Scene = {
  readonly view: MapView;
  readonly map: MapMessage | undefined;
  readonly mapPicture: HTMLCanvasElement | undefined;
  readonly belief: BeliefGrid | undefined;
  readonly beliefPicture: HTMLCanvasElement | undefined;
  readonly state: State | undefined;
  readonly plan: Plan | undefined;
  readonly robotName: string;
  readonly chosen: { readonly [Kind in PlaceKind]?: { at: PointInMap; settled: boolean } | undefined };
  readonly found: PointInMap | undefined;
  readonly stale: boolean;
  /** Added to the ages in the state [s]. */
  readonly since: number;
  readonly palette: Palette;
  readonly sources: readonly Source[];
  /** What the person is drawing now. */
  readonly drawing: { readonly edit: string; readonly outline: readonly PointInMap[] } | undefined;
  readonly betweenPeople: boolean;
  /** How wide the ring around a lost person is, [0, 1]. */
  readonly pulse: number;
  /** A keyboard would tap the middle. */
  readonly showsCrosshair: boolean;
  readonly labels: {
    readonly you: string;
    readonly robot: string;
    readonly partner: string;
    readonly laser: string;
    readonly message: string;
    readonly predicted: string;
  };
};

type Context = CanvasRenderingContext2D;

/** Draws `scene` into a canvas that is `ratio` times as fine as the screen's pixels. */
export function drawScene(context: Context, scene: Scene, ratio: number): void {
  const { view } = scene;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.fillStyle = scene.palette.around;
  context.fillRect(0, 0, view.width, view.height);
  drawPictures(context, scene, ratio);
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  drawSources(context, scene);
  for (const path of scene.plan?.paths ?? []) {
    const points = path.points.map(([, x, y]) => toScreen(view, pointInMap(x, y)));
    const robot = path.agent === scene.robotName;
    shape.path(context, points, robot ? shape.kRobot : shape.kMyGoal, robot, scene.plan?.state === "proposed");
  }
  drawGoals(context, scene);
  drawTeam(context, scene);
  if (scene.found !== undefined) shape.star(context, toScreen(view, scene.found));
  if (scene.showsCrosshair) {
    shape.crosshair(context, pointOnScreen(view.width / 2, view.height / 2), scene.palette);
  }
  if (scene.stale) {
    context.fillStyle = "rgba(120, 125, 130, 0.4)";
    context.fillRect(0, 0, view.width, view.height);
  }
}

function drawPictures(context: Context, scene: Scene, ratio: number): void {
  const { view, map, mapPicture, belief, beliefPicture } = scene;
  const inMap = () => {
    context.setTransform(ratio, 0, 0, ratio, (ratio * view.width) / 2, (ratio * view.height) / 2);
    context.rotate(-view.turn);
    context.scale(view.pixelsPerMetre, view.pixelsPerMetre);
    context.translate(-view.centre.x, view.centre.y);
  };
  if (map !== undefined && mapPicture !== undefined) {
    inMap();
    context.translate(map.x, -map.y);
    context.rotate(-map.heading);
    const height = map.height * map.resolution_m;
    context.imageSmoothingEnabled = view.pixelsPerMetre * map.resolution_m < 2;
    context.drawImage(mapPicture, 0, -height, map.width * map.resolution_m, height);
  }
  if (belief !== undefined && beliefPicture !== undefined) {
    inMap();
    const height = belief.height * belief.resolution;
    context.imageSmoothingEnabled = true;
    context.drawImage(beliefPicture, belief.x, -belief.y - height, belief.width * belief.resolution, height);
  }
}

const colourOf = (edit: string): string =>
  edit === "avoid" || edit === "not_here" || edit === "searched" ? shape.kAvoid : shape.kWanted;

/** What people have drawn, and what is being drawn. */
function drawSources(context: Context, scene: Scene): void {
  const { view, drawing } = scene;
  for (const source of scene.sources) {
    const corners = source.outline.map(([x, y]) => toScreen(view, pointInMap(x, y)));
    shape.area(context, corners, source.radius_m * view.pixelsPerMetre, colourOf(source.edit), false);
  }
  if (drawing === undefined) return;
  const corners = drawing.outline.map((at) => toScreen(view, at));
  shape.area(context, corners, view.pixelsPerMetre, colourOf(drawing.edit), true);
}

function drawGoals(context: Context, scene: Scene): void {
  const at = (point: PointInMap): PointOnScreen => toScreen(scene.view, point);
  for (const path of scene.plan?.paths ?? []) {
    const robot = path.agent === scene.robotName;
    const mine = robot ? scene.chosen.robot_goal : scene.chosen.my_goal;
    if (mine !== undefined && !mine.settled) continue; // the new wish is drawn instead
    const goal = at(pointInMap(path.goal[0], path.goal[1]));
    if (robot) shape.robotGoal(context, goal, path.goal_fixed);
    else shape.myGoal(context, goal, path.goal_fixed);
  }
  const { my_goal: myGoal, robot_goal: robotGoal, my_pose: myPose, robot_pose: robotPose } = scene.chosen;
  const inPlan = (robot: boolean) =>
    scene.plan?.paths.some((path) => (path.agent === scene.robotName) === robot && path.goal_fixed) === true;
  if (myGoal !== undefined && !(myGoal.settled && inPlan(false))) shape.myGoal(context, at(myGoal.at), myGoal.settled);
  if (robotGoal !== undefined && !scene.betweenPeople && !(robotGoal.settled && inPlan(true))) {
    shape.robotGoal(context, at(robotGoal.at), robotGoal.settled);
  }
  for (const pending of [myPose, robotPose]) {
    if (pending !== undefined && !pending.settled) shape.pendingPlace(context, at(pending.at));
  }
}

function drawTeam(context: Context, scene: Scene): void {
  const { robot, person, partner } = scene.state ?? {};
  const { view, palette, labels } = scene;
  if (robot !== undefined && !scene.betweenPeople) {
    const place = toScreen(view, pointInMap(robot.x, robot.y));
    const age = robot.age_s + scene.since;
    shape.robot(context, place, robot.heading + view.turn, Math.max(22, 0.6 * view.pixelsPerMetre), shape.fade(age));
    shape.label(context, place, labelOf([labels.robot], age, robot.status !== "ok"), palette);
  }
  if (partner !== undefined) {
    const place = toScreen(view, pointInMap(partner.x, partner.y));
    const goal = partner.goal;
    if (goal !== undefined) shape.partnerGoal(context, toScreen(view, pointInMap(goal[0], goal[1])));
    shape.partner(context, place);
    shape.label(context, place, labelOf([labels.partner], partner.age_s + scene.since, false), palette);
  }
  if (person !== undefined) drawPerson(context, scene, person);
}

function drawPerson(context: Context, scene: Scene, person: Person): void {
  const { view, labels } = scene;
  const place = toScreen(view, pointInMap(person.x, person.y));
  const age = person.age_s + scene.since;
  shape.person(context, place, person.source, person.tracked, scene.pulse);
  const words = scene.betweenPeople ? [labels.you] : [labels.you, labels[person.source]];
  shape.label(context, place, labelOf(words, age, !person.tracked), scene.palette);
}

/** "You · said 4 s"; the age only when it matters. */
function labelOf(words: readonly string[], age: number, doubtful: boolean): string {
  const seconds = age >= 3 ? ` ${Math.round(age)} s` : "";
  return `${words.join(" · ")}${doubtful ? " ?" : ""}${seconds}`;
}
