/** The roles in the order of the report's counts, and how they are shown. */
export const kRoles = [
  { name: "leader_follower", words: "Robot leads, person follows", colour: "#4269d0" },
  { name: "peer_peer", words: "Peers", colour: "#6cc5b0" },
  { name: "master_slave", words: "Person commands, robot obeys", colour: "#ff725c" },
  { name: "leader_leader", words: "Both lead", colour: "#efb118" },
] as const;

export function wordsOfRole(name: string): string {
  return kRoles.find((role) => role.name === name)?.words ?? name;
}

export function colourOfRole(name: string): string {
  return kRoles.find((role) => role.name === name)?.colour ?? "#888";
}

/** Of what the robot, the person and both together have explored. */
export const kRobotColour = "#2e9e5b";
export const kHumanColour = "#ff8c1a";
export const kAllColour = "#d03a3a";
export const kFindColour = "#f2c200";
