#include "services/planner/core/srs/event_expectation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/services/planner/support/sources.hpp"

namespace tandem {
namespace {

/// An agent stands in a cell where the object lies with probability 1/2 and is detected at 1/s; standing there costs
/// 1/s until it is found.
class EventExpectationTest : public ::testing::Test {
 protected:
  EventExpectationTest() { draws_.begin_move(world_, state_, joint_); }

  static RewardWorld searched_cell() {
    RewardSource found;
    found.id = "found";
    found.boundary = Nowhere{};
    found.pool = 1.0;
    RewardSource cell = disc_source("cell", {0, 0}, 1.0, 1.0, 0.5);
    cell.flow = Flow::Proportional;
    return world_of({"a"}, {found, cell, disc_source("patience", {0, 0}, 1.0, -1.0)},
                    {soft("cell", "found"), soft("patience", "found")});
  }

  const DrawList::Draw& draw_of(const std::string& id) {
    draws_.begin_part(world_, joint_, 0.0, 1.0);
    draws_.begin_step(world_, state_);
    for (const auto& draw : draws_.draws()) {
      if (draw.source == *index_of(world_.world(), id)) return draw;
    }
    throw std::runtime_error("nobody draws from " + id);
  }

  ResolvedWorld world_{searched_cell()};
  RewardState state_ = initial_state(world_);
  AgentMove stay_ = stay_at({0, 0});
  JointMove joint_{{&stay_, 1}, 4.0};
  DrawList draws_;
};

TEST_F(EventExpectationTest, ConcernsWhatTheEventEndsButNotTheCellItself) {
  const DrawList::Draw cost = draw_of("patience");
  const DrawList::Draw cell = draw_of("cell");
  const EventExpectation expectation{world_, state_, draws_, 0.0};
  EXPECT_TRUE(expectation.concerns(cost));
  EXPECT_FALSE(expectation.concerns(cell));
}

TEST_F(EventExpectationTest, ACostCountsWithTheProbabilityThatTheObjectIsNotFoundYet) {
  const DrawList::Draw cost = draw_of("patience");
  const EventExpectation expectation{world_, state_, draws_, 0.0};
  // The integral of -(1 - (1 - exp(-t)) / 2) from 0 to 1.
  EXPECT_NEAR(expectation.expected_amount(cost, joint_, 1.0), -(0.5 + 0.5 * (1.0 - std::exp(-1.0))), 1e-12);
}

TEST_F(EventExpectationTest, WhatWasFoundBeforeCountsToo) {
  state_.drawn[world_.sources()[*index_of(world_.world(), "found")].pool] = 0.25;
  state_.left[world_.sources()[*index_of(world_.world(), "cell")].pool] = 0.0;
  const DrawList::Draw cost = draw_of("patience");
  const EventExpectation expectation{world_, state_, draws_, 0.0};
  EXPECT_NEAR(expectation.expected_amount(cost, joint_, 2.0), -1.5, 1e-12);
}

}  // namespace
}  // namespace tandem
