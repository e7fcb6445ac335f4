#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "services/common/strict_json.hpp"
#include "services/planner/core/srs/reward_world.hpp"

namespace tandem {

/// Areas by name.
using NamedAreas = std::map<std::string, Polygon>;

/// The areas in areas.json in the folder of the map, with or without a rule; none if there is no such file. Throws
/// ConfigError or FileError.
[[nodiscard]] NamedAreas load_areas_beside(const std::filesystem::path& map_yaml);

/// The reward world in an object that may hold more: asks it for areas, sources, relations, groups, knowledge and
/// message_cost. config/scenarios/reward_world.schema.json describes them.
///
/// The caller knows the agents; areas of the object come before those of the map. Throws ConfigError with file and path
/// of the key: on an unknown key within, an unknown name, and on whatever problem_of() finds.
[[nodiscard]] RewardWorld reward_world_from(StrictObject& object, const std::vector<std::string>& agents,
                                            const NamedAreas& map_areas = {});

/// The same of a file that holds nothing else; `file_name` stands in messages.
[[nodiscard]] RewardWorld parse_reward_world(std::string_view json, const std::string& file_name,
                                             const std::vector<std::string>& agents, const NamedAreas& map_areas = {});

/// The keys of a world file as an object; parse_reward_world gives the same world back, its version aside.
[[nodiscard]] nlohmann::json json_of(const RewardWorld& world);

}  // namespace tandem
