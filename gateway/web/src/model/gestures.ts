import { type PointOnScreen, type Radians, pointOnScreen, radians } from "../units";

export type GestureActions = {
  tap(at: PointOnScreen): void;
  /** One finger; `isFirst` where it began to move. */
  drag(from: PointOnScreen, to: PointOnScreen, isFirst: boolean): void;
  /** Two fingers: about `fixed`, scaled by `factor`, turned counter-clockwise. */
  pinch(fixed: PointOnScreen, factor: number, turn: Radians): void;
};

/** A finger that moved less is a tap. */
const kTapPixels = 12;

/** Turns moving fingers into taps, drags and pinches. A tap counts when the finger leaves. */
export class Gestures {
  private readonly fingers = new Map<number, PointOnScreen>();
  private start: PointOnScreen | undefined;
  private isTap = false;

  constructor(private readonly actions: GestureActions) {}

  down(finger: number, at: PointOnScreen): void {
    this.fingers.set(finger, at);
    this.isTap = this.fingers.size === 1;
    this.start = at;
  }

  move(finger: number, at: PointOnScreen): void {
    const before = this.fingers.get(finger);
    if (before === undefined || this.start === undefined) return;
    if (this.fingers.size === 1) {
      if (this.isTap && Math.hypot(at.x - this.start.x, at.y - this.start.y) < kTapPixels) return;
      this.actions.drag(this.isTap ? this.start : before, at, this.isTap);
      this.isTap = false;
    } else {
      this.pinch(finger, before, at);
    }
    this.fingers.set(finger, at);
  }

  up(finger: number): void {
    const tapped = this.isTap && this.fingers.has(finger) ? this.start : undefined;
    this.cancel(finger);
    if (tapped !== undefined) this.actions.tap(tapped);
  }

  cancel(finger: number): void {
    this.fingers.delete(finger);
    this.isTap = false;
  }

  private pinch(finger: number, before: PointOnScreen, after: PointOnScreen): void {
    const other = [...this.fingers].find(([id]) => id !== finger)?.[1];
    if (other === undefined) return;
    const wide = Math.hypot(before.x - other.x, before.y - other.y);
    const wider = Math.hypot(after.x - other.x, after.y - other.y);
    if (wide < 1 || wider < 1) return;
    const turned =
      Math.atan2(before.y - other.y, before.x - other.x) - Math.atan2(after.y - other.y, after.x - other.x);
    this.actions.pinch(pointOnScreen(other.x, other.y), wider / wide, radians(turned));
  }
}
