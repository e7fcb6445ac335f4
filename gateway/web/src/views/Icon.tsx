import type { PlaceKind } from "../protocol/commands";

/** What a tool places, as the map draws it. */
export function Icon(props: { kind: PlaceKind }) {
  return (
    <svg viewBox="0 0 24 24" aria-hidden="true">
      {shape(props.kind)}
    </svg>
  );
}

function shape(kind: PlaceKind) {
  switch (kind) {
    case "my_pose":
      return <circle cx="12" cy="12" r="8" class="ink-person" />;
    case "my_goal":
      return <path d="M12 2l9 10-9 10-9-10z" class="ink-my-goal" />;
    case "robot_goal":
      return (
        <>
          <rect x="3" y="3" width="18" height="18" class="ink-robot-goal" />
          <rect x="8" y="8" width="8" height="8" class="hole" />
        </>
      );
    case "robot_pose":
      return (
        <>
          <rect x="3" y="4" width="18" height="16" class="ink-robot" />
          <path d="M9 8l8 4-8 4z" class="hole-filled" />
        </>
      );
    case "found":
      return <path d="M12 2l3 7 7 .6-5.3 4.7L18.3 22 12 18l-6.3 4 1.6-7.7L2 9.6 9 9z" class="ink-found" />;
  }
}
