import * as store from "../store";

type Tone = "good" | "busy" | "bad" | "quiet";
type Word = { readonly text: string; readonly tone: Tone; readonly icon: string };

const kSlowMs = 400;

function linkWord(): Word {
  const texts = store.t.value;
  if (store.link.value === "connecting") return { text: texts.linkConnecting, tone: "busy", icon: "…" };
  if (store.link.value !== "open") return { text: texts.linkLost, tone: "bad", icon: "✕" };
  const robotLink = store.state.value?.link.quality;
  if (robotLink === "lost" || robotLink === "one_way") return { text: texts.linkRobotLost, tone: "bad", icon: "✕" };
  const slow = (store.roundTripMs.value ?? 0) > kSlowMs || robotLink === "weak";
  return slow ? { text: texts.linkSlow, tone: "busy", icon: "◐" } : { text: texts.linkGood, tone: "good", icon: "●" };
}

function robotWord(): Word {
  const texts = store.t.value;
  const state = store.state.value;
  if (store.foundAt.value !== undefined) return { text: texts.found, tone: "good", icon: "★" };
  if (state === undefined) return { text: texts.robotUnknown, tone: "quiet", icon: "?" };
  if (store.isStopped.value) return { text: texts.robotStopped, tone: "bad", icon: "■" };
  if (state.robot?.status === "lost") return { text: texts.robotLost, tone: "bad", icon: "?" };
  if (state.planner.activity === "computing") return { text: texts.computing, tone: "busy", icon: "…" };
  if (state.base.blocked) return { text: texts.robotBlocked, tone: "bad", icon: "▲" };
  if (state.base.moving) return { text: texts.robotMoving, tone: "good", icon: "▶" };
  if (state.planner.activity === "failed") return { text: texts.failed, tone: "bad", icon: "!" };
  return { text: texts.robotWaiting, tone: "quiet", icon: "❚❚" };
}

/** The seconds of a plan that is being computed. */
function computing(): { detail: string } | Record<string, never> {
  const seconds = store.computingSeconds.value;
  return seconds === undefined || store.isStopped.value ? {} : { detail: `${seconds} ${store.t.value.seconds}` };
}

function roleWord(): string {
  const texts = store.t.value;
  switch (store.plan.value?.role) {
    case "leader_follower":
      return texts.roleLeaderFollower;
    case "peer_peer":
      return texts.rolePeerPeer;
    case "master_slave":
      return texts.roleMasterSlave;
    case "leader_leader":
      return texts.roleLeaderLeader;
    default:
      return texts.roleNone;
  }
}

function Chip(props: { word: Word; name: string; detail?: string }) {
  return (
    <span class={`chip ${props.word.tone}`} data-name={props.name}>
      <span aria-hidden="true">{props.word.icon}</span>
      {props.name === "robot" && <span class="hidden">{store.t.value.robot}: </span>} {props.word.text}
      {props.detail !== undefined && <small> {props.detail}</small>}
    </span>
  );
}

export function StatusStrip() {
  const roundTrip = store.roundTripMs.value;
  const detail = store.isConnected.value && roundTrip !== undefined ? `${Math.round(roundTrip)} ms` : undefined;
  return (
    <header class={store.isConnected.value ? "strip" : "strip unlinked"}>
      <div class="strip-row">
        <Chip word={linkWord()} name="link" {...(detail === undefined ? {} : { detail })} />
        {!store.isBetweenPeople.value && <Chip word={robotWord()} name="robot" {...computing()} />}
      </div>
      <div class="strip-row" hidden={store.isBetweenPeople.value}>
        <span class="role" data-name="role">
          {roleWord()}
        </span>
        <span class="explored" data-name="explored">
          {Math.round(100 * (store.state.value?.explored ?? 0))} % {store.t.value.explored}
        </span>
      </div>
    </header>
  );
}
