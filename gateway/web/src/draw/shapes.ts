import type { PointOnScreen } from "../units";
import type { Palette } from "./palette";

/** Okabe-Ito and Tol hues; everything also differs by shape, for those who do not tell colours apart. */
export const kPerson = "#117733";
export const kLostPerson = "#C1121F";
export const kRobot = "#0072B2";
export const kMyGoal = "#D55E00";
export const kRobotGoal = "#56B4E9";
const kInk = "#111418";
export const kPartner = "#CC79A7";
/** Of what is drawn: places to keep out of, and places that pay. */
export const kAvoid = "#C1121F";
export const kWanted = "#009E73";

type Context = CanvasRenderingContext2D;

/** How solid something of this age is drawn. */
export const fade = (ageS: number): number => (ageS < 3 ? 1 : ageS < 10 ? 0.6 : 0.35);

/** The person's path is solid, the robot's dashed; a proposal is thinner until it is accepted. */
export function path(
  context: Context,
  points: readonly PointOnScreen[],
  colour: string,
  dashed: boolean,
  proposed: boolean,
): void {
  if (points.length < 2) return;
  const trace = () => {
    context.beginPath();
    points.forEach((point, index) => (index === 0 ? context.moveTo(point.x, point.y) : context.lineTo(point.x, point.y)));
    context.stroke();
  };
  context.save();
  context.lineJoin = "round";
  context.lineCap = "round";
  context.strokeStyle = "#ffffff";
  context.lineWidth = 9;
  trace();
  context.strokeStyle = colour;
  context.lineWidth = proposed ? 4 : 5;
  if (dashed) {
    context.lineCap = "butt";
    context.setLineDash([10, 6]);
  }
  trace();
  context.restore();
}

function outlined(context: Context, fill: string | undefined, line: string, draw: () => void): void {
  context.save();
  context.lineJoin = "round";
  context.beginPath();
  draw();
  context.lineWidth = 8;
  context.strokeStyle = "#ffffff";
  context.stroke();
  context.fillStyle = fill ?? "#ffffff";
  context.fill();
  context.lineWidth = 3;
  context.strokeStyle = line;
  context.stroke();
  context.restore();
}

/**
 * A disc: full when the laser sees the person, with a white middle where they said they are, hollow with a "?" and a
 * red ring around it when the robot has lost them. `pulse` in [0, 1] widens that ring.
 */
export function person(
  context: Context,
  at: PointOnScreen,
  source: "laser" | "message" | "predicted",
  tracked: boolean,
  pulse: number,
): void {
  const colour = tracked ? kPerson : kLostPerson;
  if (!tracked) ring(context, at, 15 + 6 * pulse, colour);
  outlined(context, tracked ? colour : undefined, colour, () => context.arc(at.x, at.y, 11, 0, 2 * Math.PI));
  if (!tracked) {
    text(context, at.x, at.y, "?", colour, "#ffffff", 16);
  } else if (source === "message") {
    dot(context, at, 4, "#ffffff");
  }
}

/** A triangle. */
export function partner(context: Context, at: PointOnScreen): void {
  outlined(context, kPartner, kInk, () => {
    context.moveTo(at.x, at.y - 13);
    context.lineTo(at.x + 13, at.y + 10);
    context.lineTo(at.x - 13, at.y + 10);
    context.closePath();
  });
}

/** A hollow triangle, standing on its tip. */
export function partnerGoal(context: Context, at: PointOnScreen): void {
  outlined(context, undefined, kPartner, () => {
    context.moveTo(at.x, at.y + 13);
    context.lineTo(at.x + 13, at.y - 10);
    context.lineTo(at.x - 13, at.y - 10);
    context.closePath();
  });
}

/** An outline that a person drew, closed; a single corner is a disc of `radius`. */
export function area(
  context: Context,
  corners: readonly PointOnScreen[],
  radius: number,
  colour: string,
  pending: boolean,
): void {
  const first = corners[0];
  if (first === undefined) return;
  context.save();
  context.beginPath();
  if (corners.length === 1) context.arc(first.x, first.y, Math.max(8, radius), 0, 2 * Math.PI);
  else corners.forEach((at, index) => (index === 0 ? context.moveTo(at.x, at.y) : context.lineTo(at.x, at.y)));
  if (corners.length > 2) context.closePath();
  context.globalAlpha = 0.25;
  context.fillStyle = colour;
  context.fill();
  context.globalAlpha = 1;
  context.lineJoin = "round";
  context.strokeStyle = "#ffffff";
  context.lineWidth = 6;
  context.stroke();
  context.strokeStyle = colour;
  context.lineWidth = 3;
  if (pending) context.setLineDash([6, 5]);
  context.stroke();
  context.restore();
}

/** Where the keyboard's tap falls. */
export function crosshair(context: Context, at: PointOnScreen, palette: Palette): void {
  context.save();
  for (const [colour, width] of [[palette.halo, 5], [palette.ink, 2]] as const) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    context.moveTo(at.x - 18, at.y);
    context.lineTo(at.x + 18, at.y);
    context.moveTo(at.x, at.y - 18);
    context.lineTo(at.x, at.y + 18);
    context.stroke();
  }
  context.restore();
}

function ring(context: Context, at: PointOnScreen, radius: number, colour: string): void {
  context.save();
  context.beginPath();
  context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
  context.strokeStyle = colour;
  context.lineWidth = 3;
  context.stroke();
  context.restore();
}

function dot(context: Context, at: PointOnScreen, radius: number, colour: string): void {
  context.beginPath();
  context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
  context.fillStyle = colour;
  context.fill();
}

export function robot(context: Context, at: PointOnScreen, heading: number, size: number, alpha: number): void {
  context.save();
  context.globalAlpha = alpha;
  context.translate(at.x, at.y);
  context.rotate(-heading);
  const half = size / 2;
  outlined(context, kRobot, kInk, () => context.rect(-half, -0.85 * half, size, 0.85 * size));
  context.beginPath();
  context.moveTo(half - 2, 0);
  context.lineTo(-half / 3, -half / 2);
  context.lineTo(-half / 3, half / 2);
  context.closePath();
  context.fillStyle = "#ffffff";
  context.fill();
  context.restore();
}

/** A diamond: full when a person chose it, hollow otherwise. */
export function myGoal(context: Context, at: PointOnScreen, fixed: boolean): void {
  outlined(context, fixed ? kMyGoal : undefined, kMyGoal, () => {
    context.moveTo(at.x, at.y - 13);
    context.lineTo(at.x + 11, at.y);
    context.lineTo(at.x, at.y + 13);
    context.lineTo(at.x - 11, at.y);
    context.closePath();
  });
}

/** A square in a square. */
export function robotGoal(context: Context, at: PointOnScreen, fixed: boolean): void {
  outlined(context, fixed ? kRobotGoal : undefined, kRobot, () => context.rect(at.x - 11, at.y - 11, 22, 22));
  context.save();
  context.strokeStyle = kRobot;
  context.lineWidth = 2.5;
  context.strokeRect(at.x - 5, at.y - 5, 10, 10);
  context.restore();
}

/** A dashed ring: sent, not yet taken. */
export function pendingPlace(context: Context, at: PointOnScreen): void {
  context.save();
  context.beginPath();
  context.arc(at.x, at.y, 13, 0, 2 * Math.PI);
  context.strokeStyle = "#ffffff";
  context.lineWidth = 7;
  context.stroke();
  context.strokeStyle = kInk;
  context.lineWidth = 3;
  context.setLineDash([5, 4]);
  context.stroke();
  context.restore();
}

export function star(context: Context, at: PointOnScreen): void {
  outlined(context, "#FFD60A", kInk, () => {
    for (let i = 0; i < 10; i += 1) {
      const radius = i % 2 === 0 ? 17 : 7.5;
      const angle = (i * Math.PI) / 5 - Math.PI / 2;
      context.lineTo(at.x + radius * Math.cos(angle), at.y + radius * Math.sin(angle));
    }
    context.closePath();
  });
}

export function label(context: Context, at: PointOnScreen, name: string, palette: Palette): void {
  text(context, at.x, at.y + 27, name, palette.ink, palette.halo, 13);
}

function text(
  context: Context,
  x: number,
  y: number,
  words: string,
  colour: string,
  halo: string,
  size: number,
): void {
  context.save();
  context.font = `700 ${size}px system-ui, sans-serif`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineJoin = "round";
  context.lineWidth = 4;
  context.strokeStyle = halo;
  context.strokeText(words, x, y);
  context.fillStyle = colour;
  context.fillText(words, x, y);
  context.restore();
}
