#pragma once

#include <vector>

#include "services/planner/core/team/leg_book.hpp"
#include "services/planner/core/team/prepared_problem.hpp"

namespace tandem {

/// What the walks and values of one problem read: legs by member, mass, what is looked at anyway.
struct TeamGround {
  const PreparedProblem* problem = nullptr;
  std::vector<LegBook*> books;                         ///< per member
  std::vector<std::vector<std::int32_t>> start_views;  ///< per member, cells in view while it turns at its start
  std::vector<float> mass;                             ///< per cell, of all objects together
  std::vector<float> unpromised;                       ///< what is left of it after what is looked at anyway
  bool first_sight = false;                            ///< all find what they see
};

/// `problem` must outlive the ground.
[[nodiscard]] TeamGround team_ground(const PreparedProblem& problem);

/// How many of its cells come into view on a leg before `end_s` of it.
[[nodiscard]] std::size_t cells_until(const CompactLeg& leg, double end_s);

/// Takes from `mass` what is detected of the first `cells` cells on a leg, and gives it.
float take_detected(const CompactLeg& leg, std::size_t cells, bool first_sight, std::vector<float>& mass);

}  // namespace tandem
