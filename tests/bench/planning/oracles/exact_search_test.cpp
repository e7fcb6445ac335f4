#include "bench/planning/oracles/exact_search.hpp"

#include <gtest/gtest.h>

#include "services/common/random.hpp"

namespace tandem::bench {
namespace {

/// Rooms in a row.
RoomGraph corridor(const std::vector<double>& mass) {
  RoomGraph graph{mass, std::vector<std::vector<int>>(mass.size())};
  for (std::size_t room = 1; room < mass.size(); ++room) {
    graph.neighbours[room].push_back(static_cast<int>(room) - 1);
    graph.neighbours[room - 1].push_back(static_cast<int>(room));
  }
  return graph;
}

/// 4 x 4 rooms with some doors closed, random masses.
RoomGraph random_rooms(Rng& rng) {
  RoomGraph graph{std::vector<double>(16), std::vector<std::vector<int>>(16)};
  double sum = 0.0;
  for (double& mass : graph.mass) sum += mass = rng.uniform();
  for (double& mass : graph.mass) mass /= sum;
  const auto join = [&](int a, int b) {
    graph.neighbours[static_cast<std::size_t>(a)].push_back(b);
    graph.neighbours[static_cast<std::size_t>(b)].push_back(a);
  };
  for (int room = 0; room < 16; ++room) {
    if (room % 4 != 3 && rng.uniform() < 0.85) join(room, room + 1);
    if (room < 12 && rng.uniform() < 0.85) join(room, room + 4);
  }
  return graph;
}

TEST(ExactSearch, ACorridorIsWalkedToItsEnd) {
  // Left in the middle: 1 at first, then 0.75, 0.5, 0.25 at steps 1, 2, 3.
  const RoomGraph graph = corridor({0.0, 0.25, 0.25, 0.25, 0.25});
  EXPECT_DOUBLE_EQ(exact_graph_search(graph, {0}, 10), 1.0 + 0.75 + 0.5 + 0.25);
  EXPECT_DOUBLE_EQ(exact_search(model_of(graph, {0}, 10), 1e9, 1'000'000).expected_time_s, 2.5);
}

// T15: a small chance near on one side, a large one further on the other: the large one first.
TEST(ExactSearch, T15TheLikelyRoomFirst) {
  const RoomGraph graph = corridor({0.2, 0.0, 0.0, 0.0, 0.8});
  const ExactPlan plan = exact_search(model_of(graph, {1}, 20), 1e9, 1'000'000);
  EXPECT_DOUBLE_EQ(plan.expected_time_s, 0.8 * 3.0 + 0.2 * 7.0);
  EXPECT_TRUE(plan.proven);
}

// T16: with two, each takes one side.
TEST(ExactSearch, T16TwoShareTheRooms) {
  const RoomGraph graph = corridor({0.2, 0.0, 0.0, 0.0, 0.8});
  EXPECT_DOUBLE_EQ(exact_search(model_of(graph, {1, 1}, 20), 1e9, 1'000'000).expected_time_s, 0.8 * 3.0 + 0.2 * 1.0);
  EXPECT_DOUBLE_EQ(exact_graph_search(graph, {1, 1}, 20), 2.6);
}

TEST(ExactSearch, WhatIsLeftCountsAsTheHorizonAndTheTail) {
  ExactModel model = model_of(corridor({0.5, 0.0, 0.0, 0.5}), {0}, 2);
  model.tail_s = 10.0;
  EXPECT_DOUBLE_EQ(exact_search(model, 1e9, 1000).expected_time_s, 0.5 * 12.0);
}

TEST(ExactSearch, SaysWhenItGaveUp) {
  Rng rng{3};
  EXPECT_FALSE(exact_search(model_of(random_rooms(rng), {0, 15}, 10), 1e9, 50).proven);
}

// T21: two oracles that share no code agree.
TEST(ExactSearch, T21BranchAndBoundFindsWhatDynamicProgrammingFinds) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Rng rng{seed};
    const RoomGraph graph = random_rooms(rng);
    const auto place = [&] { return static_cast<int>(rng.index(16)); };
    const std::vector<int> starts = seed % 2 == 0 ? std::vector{place()} : std::vector{place(), place()};
    const int steps = seed % 2 == 0 ? 10 : 5;
    const ExactPlan plan = exact_search(model_of(graph, starts, steps), 1e9, 20'000'000);
    ASSERT_TRUE(plan.proven) << "seed " << seed;
    EXPECT_NEAR(plan.expected_time_s, exact_graph_search(graph, starts, steps), 1e-9) << "seed " << seed;
  }
}

TEST(ExactSearch, LegsOfDifferentLengthAreTakenInTheBestOrder) {
  // From place 0: place 1 in 4 s shows cell 0 (0.5), place 2 in 1 s shows cell 1 (0.5); between them 5 s.
  ExactModel model;
  model.mass = {0.5, 0.5};
  model.horizon_s = 100.0;
  ExactModel::Agent agent;
  agent.legs_from = {{{1, 4.0, {{0, 4.0}}}, {2, 1.0, {{1, 1.0}}}}, {{2, 5.0, {{1, 5.0}}}}, {{1, 5.0, {{0, 5.0}}}}};
  model.agents = {agent};
  const ExactPlan plan = exact_search(model, 1e9, 1000);
  EXPECT_DOUBLE_EQ(plan.expected_time_s, 0.5 * 1.0 + 0.5 * 6.0);
  EXPECT_EQ(plan.places, (std::vector<std::vector<int>>{{2, 1}}));
}

}  // namespace
}  // namespace tandem::bench
