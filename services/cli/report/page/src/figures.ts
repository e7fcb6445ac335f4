import * as Plot from "@observablehq/plot";
import type { Comparison, Group, Report } from "./data";
import { stars } from "./elements";
import { kAllColour, kFindColour, kHumanColour, kRobotColour, kRoles } from "./roles";

type Figure = SVGSVGElement | HTMLElement;

const kWidth = 860;
const share = { domain: [0, 1], tickFormat: (value: number) => `${Math.round(100 * value)} %`, grid: true };

/** Fig. 22: each episode a green and an orange stripe, the means on top, a dot where the object was found. */
export function progressFigure(report: Report, group: Group): Figure {
  const stripes = group.episodes.flatMap((index) =>
    (report.episodes[index]?.explored ?? []).map(([t, robot, all]) => ({ index, t, robot, all })),
  );
  const finds = group.episodes.flatMap((index) => {
    const episode = report.episodes[index];
    const end = episode?.explored.at(-1);
    return episode !== undefined && end !== undefined && episode.outcome === "found"
      ? [{ t: end[0], all: end[2], name: episode.name }]
      : [];
  });
  const opacity = Math.max(0.06, 0.7 / Math.max(1, group.episodes.length));
  const means = group.explored.map(([t, ongoing, robot, all]) => ({ t, ongoing, robot, all }));
  return Plot.plot({
    width: kWidth,
    height: 340,
    marginLeft: 52,
    ariaLabel: `Explored over time, ${group.name}`,
    x: { label: "time [s]" },
    y: { ...share, label: "explored" },
    marks: [
      Plot.areaY(stripes, { x: "t", y1: 0, y2: "robot", z: "index", fill: kRobotColour, fillOpacity: opacity }),
      Plot.areaY(stripes, { x: "t", y1: "robot", y2: "all", z: "index", fill: kHumanColour, fillOpacity: opacity }),
      Plot.lineY(means, { x: "t", y: "robot", stroke: kRobotColour, strokeWidth: 3 }),
      Plot.lineY(means, { x: "t", y: "all", stroke: kAllColour, strokeWidth: 3 }),
      Plot.dot(finds, { x: "t", y: "all", r: 5, fill: kFindColour, stroke: "#6b5600", title: "name" }),
      Plot.ruleY([0]),
    ],
  });
}

/** Fig. 24: of the episodes that go on, how many in each role; the line says how many still go on. */
export function rolesFigure(group: Group): Figure {
  const shares = group.roles.flatMap(([t, ongoing, inRole]) =>
    kRoles.map((role, i) => ({ t, role: role.name, share: ongoing > 0 ? (inRole[i] ?? 0) / ongoing : 0 })),
  );
  const ongoing = group.roles.map(([t, count]) => ({ t, share: count / Math.max(1, group.episodes.length) }));
  return Plot.plot({
    width: kWidth,
    height: 280,
    marginLeft: 52,
    ariaLabel: `Roles over time, ${group.name}`,
    x: { label: "time [s]" },
    y: { ...share, label: "episodes in the role" },
    color: { domain: kRoles.map((role) => role.name), range: kRoles.map((role) => role.colour) },
    marks: [
      Plot.areaY(shares, { x: "t", y: "share", fill: "role", fillOpacity: 0.85, curve: "step-after", order: kRoles.map((role) => role.name) }),
      Plot.lineY(ongoing, { x: "t", y: "share", stroke: "currentColor", strokeWidth: 1.5, strokeDasharray: "4 3", curve: "step-after" }),
      Plot.ruleY([0]),
    ],
  });
}

/** Fig. 19: how the share of *My pose* messages within the threshold goes on, by group. */
export function messagesFigure(report: Report): Figure {
  const rows = report.groups.flatMap((group) =>
    group.my_pose
      .filter((row) => row.with_messages > 0)
      .map((row) => ({ group: group.name, until: row.until_s === null ? "all" : `${row.until_s} s`, within: row.within })),
  );
  return Plot.plot({
    width: kWidth,
    height: 260,
    marginLeft: 52,
    marginRight: 90,
    ariaLabel: "My pose messages within the threshold",
    x: { type: "point", domain: ["60 s", "90 s", "120 s", "all"], label: "of the first" },
    y: { ...share, label: `within ${report.threshold_s} s` },
    color: { legend: report.groups.length > 1 },
    marks: [
      Plot.lineY(rows, { x: "until", y: "within", stroke: "group", z: "group", strokeWidth: 2 }),
      Plot.dot(rows, { x: "until", y: "within", fill: "group", r: 4, title: "group" }),
    ],
  });
}

/** Figs. 18 and 20: what people answered, with the stars of the analysis of variance. */
export function answersFigure(report: Report, questions: Comparison[]): Figure {
  const bars = questions.flatMap((question) =>
    question.groups.map((value, i) => ({
      question: `${question.measure} ${stars(question.anova.p)}`.trim(),
      group: report.groups[i]?.name ?? "",
      mean: value.mean,
      low: value.mean - value.deviation,
      high: value.mean + value.deviation,
    })),
  );
  return Plot.plot({
    width: kWidth,
    height: 60 + 34 * Math.max(1, bars.length),
    marginLeft: 120,
    marginRight: 150,
    ariaLabel: "Answers by group",
    x: { label: "mean answer", grid: true, zero: true },
    y: { label: null },
    fy: { label: null },
    color: { legend: report.groups.length > 1 },
    marks: [
      Plot.barX(bars, { x: "mean", y: "group", fy: "question", fill: "group", fillOpacity: 0.8 }),
      Plot.ruleY(bars, { x1: "low", x2: "high", y: "group", fy: "question", strokeWidth: 2 }),
    ],
  });
}

/** Why, and for how long an episode, the robot was stopped. */
export function stopsFigure(report: Report): Figure | undefined {
  const rows = report.groups.flatMap((group) => {
    const sums = new Map<string, number>();
    for (const index of group.episodes) {
      for (const [reason, { s }] of Object.entries(report.episodes[index]?.stops ?? {})) {
        sums.set(reason, (sums.get(reason) ?? 0) + s);
      }
    }
    return [...sums].map(([reason, s]) => ({ group: group.name, reason, s: s / group.episodes.length }));
  });
  if (rows.length === 0) return undefined;
  const reasons = new Set(rows.map((row) => row.reason)).size;
  return Plot.plot({
    width: kWidth,
    height: 60 + 26 * reasons * report.groups.length,
    marginLeft: 90,
    marginRight: 240,
    ariaLabel: "Stops by reason",
    x: { label: "stopped per episode [s]", grid: true },
    y: { label: null },
    fy: { label: null },
    color: { legend: report.groups.length > 1 },
    marks: [Plot.barX(rows, { x: "s", y: "group", fy: "reason", fill: "group" }), Plot.ruleX([0])],
  });
}

/** How much of the time the robot was how near to its person and to others (Hall's zones). */
export function zonesFigure(report: Report): Figure | undefined {
  const zones = [
    ["teammate_intimate", "< 0.45 m"],
    ["teammate_personal", "0.45–1.2 m"],
    ["teammate_social", "1.2–3.6 m"],
  ] as const;
  const rows = report.groups.flatMap((group, i) =>
    zones.flatMap(([measure, words]) => {
      const value = report.comparisons.find((comparison) => comparison.measure === measure)?.groups[i];
      return value === undefined || value.n === 0 ? [] : [{ group: group.name, zone: words, share: value.mean }];
    }),
  );
  if (rows.length === 0) return undefined;
  return Plot.plot({
    width: kWidth,
    height: 70 + 34 * report.groups.length,
    marginLeft: 90,
    ariaLabel: "Distance to the teammate",
    x: { ...share, label: "of the time" },
    y: { label: null },
    color: { legend: true, domain: zones.map(([, words]) => words), range: ["#d03a3a", "#efb118", "#6cc5b0"] },
    marks: [Plot.barX(rows, { x: "share", y: "group", fill: "zone" }), Plot.ruleX([0])],
  });
}
