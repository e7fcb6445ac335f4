#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "services/planner/core/srs/reward_world.hpp"

namespace tandem {

// The words of world files, one table for reading and writing each.

template <typename Value, std::size_t Count>
using Words = std::array<std::pair<std::string_view, Value>, Count>;

inline constexpr Words<SourceKind, 4> kSourceKindWords{{{"environment", SourceKind::Environment},
                                                        {"action", SourceKind::Action},
                                                        {"task", SourceKind::Task},
                                                        {"interaction", SourceKind::Interaction}}};
inline constexpr Words<Flow, 2> kFlowWords{{{"steady", Flow::Steady}, {"proportional", Flow::Proportional}}};
inline constexpr Words<RatioShape, 3> kRatioShapeWords{
    {{"constant", RatioShape::Constant}, {"exponential", RatioShape::Exponential}, {"ramp", RatioShape::Ramp}}};
inline constexpr Words<RelationKind, 3> kRelationKindWords{
    {{"strict", RelationKind::Strict}, {"soft", RelationKind::Soft}, {"codependent", RelationKind::Codependent}}};
inline constexpr Words<Trigger::Kind, 3> kTriggerWords{
    {{"fraction", Trigger::Kind::Fraction}, {"amount", Trigger::Kind::Amount}, {"entry", Trigger::Kind::Entry}}};

template <typename Value, std::size_t Count>
[[nodiscard]] std::string word_of(const Words<Value, Count>& words, Value value) {
  for (const auto& [word, one] : words) {
    if (one == value) return std::string{word};
  }
  return {};
}

}  // namespace tandem
