import type { Comparison, Episode, Report } from "./data";
import { loadReport } from "./data";
import { element, number, percent, pValue, section, stars, table } from "./elements";
import { answersFigure, messagesFigure, progressFigure, rolesFigure, stopsFigure, zonesFigure } from "./figures";
import { kAllColour, kFindColour, kHumanColour, kRobotColour, kRoles } from "./roles";
import { scrubber } from "./scrubber";

const kSessionFields = ["condition", "reminder", "mode"];

const isShare = (name: string) => /^(found|explored|slowed|link_up|.*_idle|both_active|.*_(intimate|personal|social))/.test(name);

function shown(name: string, value: number | null | undefined): string {
  return isShare(name) ? percent(value, 1) : number(value, 2);
}

function key(...entries: [colour: string, words: string][]): HTMLElement {
  return element("p", { class: "legend" },
    ...entries.flatMap(([colour, words]) => [element("span", { class: "key", style: `background:${colour}` }), ` ${words}  `]));
}

function head(report: Report): HTMLElement {
  const found = report.episodes.filter((episode) => episode.outcome === "found").length;
  const mean = report.episodes.reduce((sum, episode) => sum + episode.duration_s, 0) / Math.max(1, report.episodes.length);
  const groups = report.by === "" ? "" : ` Split by ${report.by}: ${report.groups.map((group) => `${group.name} (${group.episodes.length})`).join(", ")}.`;
  return element("header", {},
    element("h1", {}, report.title),
    element("p", { class: "words", "data-name": "summary" },
      `${report.episodes.length} ${report.episodes.length === 1 ? "episode" : "episodes"}, found in ${found}; ${number(mean)} s on average.${groups}`));
}

function forEachGroup(report: Report, make: (index: number) => Node): Node[] {
  return report.groups.flatMap((group, i) =>
    report.groups.length > 1 ? [element("h3", {}, group.name), make(i)] : [make(i)]);
}

function progressSection(report: Report): HTMLElement {
  return section("Search progress",
    "Each episode is a stripe: what the robot was first to see, and on top of it the person. Thick lines are means over the episodes that still go on; a dot is a find.",
    key([kRobotColour, "by the robot"], [kHumanColour, "by the person"], [kAllColour, "by both, mean"], [kFindColour, "found"]),
    ...forEachGroup(report, (i) => progressFigure(report, report.groups[i]!)));
}

function rolesSection(report: Report): HTMLElement {
  return section("Collaboration roles",
    "Of the episodes that still go on, how many are in which role; white: no plan yet. The dashed line is the share of episodes that go on.",
    key(...kRoles.map((role): [string, string] => [role.colour, role.words])),
    ...forEachGroup(report, (i) => rolesFigure(report.groups[i]!)));
}

function messagesSection(report: Report): HTMLElement {
  const rows = report.groups.flatMap((group) => {
    const cells = (words: (row: (typeof group.my_pose)[number]) => string) => group.my_pose.map(words);
    return [
      [`${group.name}: messages a minute (std. dev.)`, ...cells((row) => `${number(row.per_min, 2)} (${number(row.deviation, 2)})`)],
      [`${group.name}: within ${report.threshold_s} s`, ...cells((row) => (row.with_messages > 0 ? percent(row.within, 2) : "–"))],
    ];
  });
  const matched = report.groups
    .filter((group) => group.matching_threshold_s > 0)
    .map((group) => `${group.name}: ${number(group.matching_threshold_s, 2)} s`);
  return section("My pose messages",
    "How often people said where they are, and how many of these messages came within the threshold after the one before, in the beginnings of the episodes and in all of them.",
    table(["", "60 s", "90 s", "120 s", "whole episode"], rows, { "data-name": "my_pose" }),
    ...(matched.length > 0 ? [element("p", { class: "words" }, `Threshold that gives the share of ${report.baseline} at ${report.threshold_s} s: ${matched.join("; ")}.`)] : []),
    messagesFigure(report));
}

function comparisonRows(report: Report, comparisons: Comparison[], words: (name: string) => string): (string | Node)[][] {
  return comparisons
    .filter((comparison) => comparison.groups.some((value) => value.n > 0))
    .map((comparison) => [
      words(comparison.measure),
      ...comparison.groups.map((value) =>
        value.n === 0 ? "–" : `${shown(comparison.measure, value.mean)} (${shown(comparison.measure, value.deviation)})`),
      ...(report.groups.length > 1 ? [
        comparison.anova.within > 0
          ? `F(${comparison.anova.between}, ${comparison.anova.within}) = ${number(comparison.anova.f, 2)}, p ${pValue(comparison.anova.p)} ${stars(comparison.anova.p)}`
          : "–",
        pairWords(comparison),
      ] : []),
    ]);
}

function pairWords(comparison: Comparison): Node {
  return element("span", {}, ...comparison.pairs.map((pair) =>
    element("span", { class: "pair" },
      `${pair.b} – ${pair.a}: g = ${number(pair.g, 2)} [${number(pair.low, 2)}, ${number(pair.high, 2)}], p ${pValue(pair.p)}, Holm ${pValue(pair.p_holm)}${pair.pairs > 0 ? `, ${pair.pairs} pairs` : ""}`)));
}

function comparisonHead(report: Report): string[] {
  return ["mean (std. dev.)", ...report.groups.map((group) => group.name), ...(report.groups.length > 1 ? ["ANOVA", "pairs: Hedges' g, permutation test"] : [])];
}

function measuresSection(report: Report): HTMLElement {
  const wordsOf = (name: string) => {
    const measure = report.measures.find((one) => one.name === name);
    return measure === undefined ? name : `${measure.words}${measure.unit === "" ? "" : ` [${measure.unit}]`}`;
  };
  return section("Measures", "Over episodes. What was not recorded is a dash.",
    table(comparisonHead(report), comparisonRows(report, report.comparisons, wordsOf), { "data-name": "measures" }));
}

/** Answers that are words: which was chosen how often. */
function choices(report: Report): HTMLElement | undefined {
  const counts = new Map<string, Map<string, number>>();
  for (const episode of report.episodes) {
    for (const [field, answer] of Object.entries(episode.fields)) {
      if (kSessionFields.includes(field) || field === report.by || field === report.pair || answer === "" || !Number.isNaN(Number(answer))) continue;
      const answers = counts.get(field) ?? new Map<string, number>();
      answers.set(answer, (answers.get(answer) ?? 0) + 1);
      counts.set(field, answers);
    }
  }
  if (counts.size === 0) return undefined;
  const rows = [...counts].map(([question, answers]) => [question, [...answers].sort((a, b) => b[1] - a[1]).map(([answer, count]) => `${answer}: ${count}`).join(", ")]);
  return table(["chosen", "how often"], rows);
}

function answersSection(report: Report): HTMLElement | undefined {
  const chosen = choices(report);
  if (report.questions.length === 0 && chosen === undefined) return undefined;
  return section("Answers", "Means and standard deviations; stars: analysis of variance, * p < 0.05, ** p < 0.01, *** p < 0.001.",
    ...(report.questions.length > 0 ? [
      answersFigure(report, report.questions),
      table(comparisonHead(report), comparisonRows(report, report.questions, (name) => name)),
    ] : []),
    ...(chosen === undefined ? [] : [chosen]));
}

function safetySection(report: Report): HTMLElement | undefined {
  const figures = [stopsFigure(report), zonesFigure(report)].filter((figure) => figure !== undefined);
  if (figures.length === 0) return undefined;
  return section("Safety and comfort", "How long the robot was stopped and why, and how near it was to its person.", ...figures);
}

function episodeWords(episode: Episode): string {
  const parts = [episode.outcome === "found" ? `Found by ${episode.found_by} after ${number(episode.duration_s)} s` : `${episode.outcome === "" ? "Unfinished" : episode.outcome}, ${number(episode.duration_s)} s`];
  if (episode.first_expected_s !== null) parts.push(`first plan: ${number(episode.first_expected_s)} s expected${episode.first_lower_bound_s === null ? "" : `, no plan below ${number(episode.first_lower_bound_s)} s`}`);
  if (episode.round_trip_s !== null) parts.push(`round trip ${number(1000 * episode.round_trip_s, 0)} ms`);
  if (episode.reminder_effect !== null) parts.push(`reminders obeyed: ${percent(episode.reminder_effect)}`);
  return [...parts, ...episode.gaps].join(" · ");
}

function episodesSection(report: Report): HTMLElement {
  const place = element("div", { class: "episode", "data-name": "episode" });
  const open = (index: number) => {
    const episode = report.episodes[index];
    const replay = report.replays?.[index];
    const map = replay === undefined ? undefined : report.maps?.[replay.map];
    if (episode === undefined) return;
    place.replaceChildren(element("h3", {}, episode.name), element("p", { class: "words" }, episodeWords(episode)));
    if (replay !== undefined && map !== undefined) place.append(scrubber(episode, replay, map));
  };
  const rows = report.episodes.map((episode, index) => {
    const link = element("button", { type: "button", class: "link" }, episode.name);
    link.addEventListener("click", () => {
      open(index);
      place.scrollIntoView({ block: "start" });
    });
    return [link, episode.outcome === "found" ? `found by ${episode.found_by}` : episode.outcome || "unfinished", number(episode.duration_s),
      percent(episode.values["explored"], 1), number(episode.values["my_pose_per_min"], 2), number(episode.values["plans"], 0), number(episode.values["stops"], 0)];
  });
  open(0);
  const isOne = rows.length === 1;
  return section(isOne ? "Replay" : "Episodes", report.replays === undefined ? "" : isOne ? "Play it, or drag through it." : "Press a name to replay it.",
    ...(!isOne ? [table(["episode", "outcome", "duration [s]", "explored", "My pose [1/min]", "plans", "stops"], rows, { "data-name": "episodes" })] : []),
    place);
}

async function run(): Promise<void> {
  const page = document.getElementById("page");
  if (page === null) return;
  const report = await loadReport();
  document.title = report.title;
  const isOne = report.episodes.length === 1;
  const parts = [
    head(report),
    ...(isOne ? [episodesSection(report)] : []),
    progressSection(report), rolesSection(report), messagesSection(report),
    safetySection(report), answersSection(report), measuresSection(report),
    ...(isOne ? [] : [episodesSection(report)]),
    element("footer", {}, "Made by tandem report. Nothing on this page comes from the network."),
  ];
  page.replaceChildren(...parts.filter((part) => part !== undefined));
  page.dataset["ready"] = "true";
}

run().catch((error: unknown) => {
  const page = document.getElementById("page");
  if (page !== null) page.textContent = `This report cannot be shown: ${String(error)}. A browser of 2023 or later is needed.`;
});
