// The properties T6 to T24 of the model that a planner of tasks must have, on worlds one can check by hand.

#include <gtest/gtest.h>

#include "bench/planning/srs_worlds/srs_world.hpp"
#include "bench/planning/srs_worlds/task_oracle.hpp"
#include "services/planner/core/tasks/task_bound.hpp"
#include "tests/services/planner/support/tasks.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kClose = 0.01;  ///< times: sources have a little size

// A corridor along x: key at 2, door at -2, start at 0, 1 m/s. Key first (2 s), then 4 m back: 6 s.
TaskProblem key_and_door() {
  return task_of({task_agent("a", 0.0, 0.0)}, {spot("key", 2.0, 0.0, 1.0), spot("door", -2.0, 0.0, 10.0)},
                 {strict("key", "door")}, 20.0);
}

TEST(TaskProperty, T6FetchesTheKeyBeforeTheDoor) {
  const TaskProblem problem = key_and_door();
  const auto plan = plan_task(problem, 1000, Rng{1});
  ASSERT_TRUE(plan);
  EXPECT_EQ(visits_of(problem, *plan, 0), "key door");
  EXPECT_NEAR(plan->value, 11.0, 1e-9);
  EXPECT_NEAR(plan->makespan_s, 6.0, kClose);
  EXPECT_TRUE(plan->is_proven());
}

TEST(TaskProperty, T7TakesTheProductBeforePayingAndSkipsItIfTimeIsShort) {
  // Product at -1, cashier at 2, exit at 3: with the product 1 + 3 + 1 = 5 s, without it 3 s.
  TaskProblem problem =
      task_of({task_agent("a", 0.0, 0.0)},
              {spot("product", -1.0, 0.0, 1.0), spot("cashier", 2.0, 0.0, 5.0), spot("exit", 3.0, 0.0, 5.0)},
              {soft("product", "cashier"), strict("cashier", "exit")}, 6.0);
  const auto leisurely = plan_task(problem, 1000, Rng{1});
  ASSERT_TRUE(leisurely);
  EXPECT_EQ(visits_of(problem, *leisurely, 0), "product cashier exit");
  EXPECT_NEAR(leisurely->value, 11.0, 1e-9);
  EXPECT_NEAR(leisurely->makespan_s, 5.0, kClose);

  problem.horizon_s = 4.0;
  const auto hurried = plan_task(problem, 1000, Rng{1});
  ASSERT_TRUE(hurried);
  EXPECT_EQ(visits_of(problem, *hurried, 0), "cashier exit");
  EXPECT_NEAR(hurried->value, 10.0, 1e-9);
  EXPECT_NEAR(hurried->makespan_s, 3.0, kClose);
}

// The switch opens the panel, which only a0 can read. a1 is 2 m from the switch, a0 5 m from the panel, 1 m/s.
TaskProblem light_and_panel() {
  return task_of({task_agent("a0", 0.0, 0.0), task_agent("a1", 0.0, 5.0)},
                 {spot("switch", 2.0, 5.0, 1.0), spot("panel", 5.0, 0.0, 10.0, {"a0"})}, {strict("switch", "panel")},
                 30.0);
}

TEST(TaskProperty, T9TheMateSwitchesTheLightOnWhileTheReaderGoesToThePanel) {
  const TaskProblem problem = light_and_panel();
  const auto plan = plan_task(problem, 1000, Rng{1});
  ASSERT_TRUE(plan);
  EXPECT_EQ(visits_of(problem, *plan, 0), "panel");
  EXPECT_EQ(visits_of(problem, *plan, 1), "switch");
  EXPECT_NEAR(plan->value, 11.0, 1e-9);
  EXPECT_NEAR(plan->makespan_s, 5.0, kClose);
  EXPECT_TRUE(plan->is_proven());
}

TEST(TaskProperty, T9TheBoundHopesForTheMate) {
  // Alone, a0 would get nothing at the panel; the bound must not say so after a0 has set out for it.
  const TaskProblem problem = light_and_panel();
  TaskModel model{problem};
  TaskBound bound{model};
  std::vector<TaskAction> actions;
  const TaskState start = model.start();
  model.actions(start, actions);
  const auto to_panel = std::ranges::find_if(actions, [](const TaskAction& a) { return a.source == 1; });
  ASSERT_NE(to_panel, actions.end());
  EXPECT_GE(bound(model.after(start, *to_panel)), 11.0);
}

TEST(TaskProperty, T9WhoDoesNotKnowTheSwitchIsNotExpectedToPressIt) {
  // A message dearer than all that could be won: a0 does both. Its way: to (2, 5), 5.39 m, then to (5, 0), 5.83 m.
  TaskProblem problem = light_and_panel();
  problem.world.unawareness = {{"a1", {"switch"}}};
  problem.world.message_cost = 100.0;
  const auto plan = plan_task(problem, 2000, Rng{1});
  ASSERT_TRUE(plan);
  EXPECT_TRUE(plan->informs.empty());
  EXPECT_EQ(visits_of(problem, *plan, 0), "switch panel");
  EXPECT_EQ(visits_of(problem, *plan, 1), "");
  EXPECT_NEAR(plan->value, 11.0, 1e-9);
  EXPECT_NEAR(plan->makespan_s, std::sqrt(29.0) + std::sqrt(34.0), kClose);
}

TEST(TaskProperty, T9TellsTheMateIfThatGainsMoreThanItCosts) {
  // 8 s are too few for a0 to do both (11.2 s): the switch alone pays 1. Told, the two get 11, less the message.
  TaskProblem problem = light_and_panel();
  problem.horizon_s = 8.0;
  problem.world.unawareness = {{"a1", {"switch"}}};
  problem.world.message_cost = 0.5;
  const auto plan = plan_task(problem, 2000, Rng{1});
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->informs.size(), 1U);
  EXPECT_EQ(plan->informs[0].agent, "a1");
  EXPECT_EQ(plan->informs[0].source, "switch");
  EXPECT_EQ(visits_of(problem, *plan, 0), "panel");
  EXPECT_EQ(visits_of(problem, *plan, 1), "switch");
  EXPECT_NEAR(plan->value, 10.5, 1e-9);
  EXPECT_NEAR(plan->value_untold, 1.0, 1e-9);

  problem.world.message_cost = 20.0;
  const auto silent = plan_task(problem, 2000, Rng{1});
  ASSERT_TRUE(silent);
  EXPECT_TRUE(silent->informs.empty());
  EXPECT_NEAR(silent->value, 1.0, 1e-9);
}

TEST(TaskProperty, T11AStateIsWhereverAnyActionEnds) {
  // A walks 3 s and then 4 s, B 5 s and then 2 s: decisions at 0, 3, 5 and 7 s.
  const TaskProblem problem = task_of({task_agent("A", 0.0, 0.0), task_agent("B", 0.0, 100.0)},
                                      {spot("A1", 3.0, 0.0, 1.0, {"A"}), spot("A2", 3.0, 4.0, 1.0, {"A"}),
                                       spot("B1", 5.0, 100.0, 1.0, {"B"}), spot("B2", 5.0, 102.0, 1.0, {"B"})},
                                      {}, 50.0);
  TaskModel model{problem};
  std::vector<TaskAction> actions;
  const auto take = [&](const TaskState& state, int source) {
    model.actions(state, actions);
    const auto found = std::ranges::find_if(actions, [&](const TaskAction& a) { return a.source == source; });
    EXPECT_NE(found, actions.end());
    return model.after(state, *found);
  };
  const auto rest_ms = [](const TaskState& state, std::size_t agent) {
    return state.agents[agent].occupation == Occupation::Free ? 0 : state.agents[agent].arrival_ms() - state.now_ms;
  };

  TaskState state = model.start();
  EXPECT_EQ(model.decider(state), 0);  // both are free: |chA| x |chB| joint decisions, here one after the other
  model.actions(state, actions);
  EXPECT_EQ(actions.size(), 3U);  // A1, A2, wait
  state = take(state, 0);
  EXPECT_EQ(state.now_ms, 0);
  EXPECT_EQ(model.decider(state), 1);
  model.actions(state, actions);
  EXPECT_EQ(actions.size(), 3U);  // B1, B2, wait
  state = take(state, 2);

  EXPECT_EQ(state.now_ms, 3000);  // remaining (0, 2): |chA|
  EXPECT_EQ(model.decider(state), 0);
  EXPECT_EQ(rest_ms(state, 0), 0);
  EXPECT_EQ(rest_ms(state, 1), 2000);
  state = take(state, 1);

  EXPECT_EQ(state.now_ms, 5000);  // remaining (2, 0): |chB|
  EXPECT_EQ(model.decider(state), 1);
  EXPECT_EQ(rest_ms(state, 0), 2000);
  EXPECT_EQ(rest_ms(state, 1), 0);
  state = take(state, 3);

  EXPECT_EQ(state.now_ms, 7000);  // both at once
  EXPECT_EQ(rest_ms(state, 0), 0);
  EXPECT_EQ(rest_ms(state, 1), 0);
  EXPECT_EQ(state.agents[0].occupation, Occupation::Free);
  EXPECT_EQ(state.agents[1].occupation, Occupation::Free);
}

TEST(TaskProperty, T17APathEndsAtTheGoalAPersonFixedAndTheOthersGoOn) {
  // The person is bound for (8, 0) and passes "near" on its way; "far" is left to the robot, after the person arrives.
  TaskProblem problem = task_of({task_agent("person", 0.0, 0.0), task_agent("robot", 0.0, 2.0)},
                                {spot("near", 4.0, 0.0, 2.0), spot("far", 0.0, 12.0, 5.0)}, {}, 30.0);
  problem.agents[0].goal_in_map = Vector2d{8.0, 0.0};
  const auto plan = plan_task(problem, 2000, Rng{1});
  ASSERT_TRUE(plan);
  const Vector2d end = plan->agents[0].path.points.back().point_in_map;
  EXPECT_LE((end - Vector2d{8.0, 0.0}).norm(), 0.5);
  EXPECT_NEAR(plan->agents[0].end_s, 8.0, kClose);
  EXPECT_EQ(visits_of(problem, *plan, 1), "far");
  EXPECT_NEAR(plan->agents[1].end_s, 10.0, kClose);
  EXPECT_NEAR(plan->value, 7.0, 1e-9);
}

TEST(TaskProperty, T18WhoHasNothingToDoWaitsAndItsHazardGoesOn) {
  RewardSource smoke = disc_source("smoke", {50.0, 0.0}, 3.0, -0.5);
  smoke.kind = SourceKind::Environment;
  const TaskProblem problem = task_of({task_agent("a", 0.0, 0.0), task_agent("b", 50.0, 0.0)},
                                      {spot("task", 4.0, 0.0, 9.0, {"a"}), smoke}, {}, 10.0);
  const auto plan = plan_task(problem, 1000, Rng{1});
  ASSERT_TRUE(plan);
  EXPECT_EQ(visits_of(problem, *plan, 0), "task");
  EXPECT_EQ(visits_of(problem, *plan, 1), "");
  EXPECT_NEAR(plan->value, 9.0 - 0.5 * 10.0, 1e-9);
  EXPECT_NEAR(plan->agents[1].reward, -5.0, 1e-9);
}

TEST(TaskProperty, T19AFirstPlanIsThereBeforeAnyRollout) {
  const TaskProblem problem = key_and_door();
  const auto plan = plan_task(problem, 0, Rng{1});
  ASSERT_TRUE(plan);
  EXPECT_EQ(visits_of(problem, *plan, 0), "key door");
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    EXPECT_TRUE(plan_task(bench::random_srs_task(seed), 0, Rng{seed})) << "seed " << seed;
  }
}

TEST(TaskProperty, T20MoreRolloutsNeverMakeThePlanWorse) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    TaskPlanner planner{bench::random_srs_task(seed), Rng{seed}};
    double value = planner.value();
    double bound = planner.upper_bound();
    for (int i = 0; i < 20; ++i) {
      planner.run(20);
      EXPECT_GE(planner.value(), value - 1e-6) << "seed " << seed;
      EXPECT_LE(planner.upper_bound(), bound + 1e-6) << "seed " << seed;
      EXPECT_LE(planner.value(), planner.upper_bound() + 1e-9) << "seed " << seed;
      value = planner.value();
      bound = planner.upper_bound();
    }
  }
}

TEST(TaskProperty, T20NoMoreIsPaidThanThePoolsHold) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const TaskProblem problem = bench::random_srs_task(seed);
    const auto plan = plan_task(problem, 200, Rng{seed});
    ASSERT_TRUE(plan);
    const std::size_t agents = problem.agents.size();
    double sum = 0.0;
    for (std::size_t s = 0; s < problem.world.sources.size(); ++s) {
      const RewardSource& source = problem.world.sources[s];
      double most_worth = 1.0;
      for (const AgentTemper& temper : source.tempers) most_worth = std::max(most_worth, temper.worth);
      double paid = 0.0;
      for (std::size_t a = 0; a < agents; ++a) paid += plan->record.paid[s * agents + a];
      EXPECT_LE(paid, source.pool * most_worth + 1e-9) << "seed " << seed << " " << source.id;
      sum += paid;
    }
    EXPECT_NEAR(sum, plan->value, 1e-9) << "seed " << seed;
  }
}

TEST(TaskProperty, T20EqualSeedsGiveEqualPlansBitForBit) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const TaskProblem problem = bench::random_srs_task(seed);
    const auto one = plan_task(problem, 300, Rng{seed});
    TaskPlanner sliced{problem, Rng{seed}};
    for (int i = 0; i < 30; ++i) sliced.run(10);
    const auto other = sliced.best();
    ASSERT_TRUE(one && other);
    EXPECT_EQ(one->value, other->value);
    EXPECT_EQ(one->upper_bound, other->upper_bound);
    for (std::size_t a = 0; a < problem.agents.size(); ++a) {
      EXPECT_EQ(one->agents[a].visits, other->agents[a].visits) << "seed " << seed;
    }
  }
}

TEST(TaskProperty, T20TheNumbersOfTheAgentsDoNotMatter) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    bench::SrsWorldOptions options;
    options.least_sources = options.most_sources = 3;
    const TaskProblem problem = bench::random_srs_task(seed, options);
    TaskProblem turned = problem;
    std::ranges::reverse(turned.agents);
    std::ranges::reverse(turned.world.agents);
    TaskPlanner one{problem, Rng{seed}};
    TaskPlanner other{turned, Rng{seed}};
    one.run(20000);
    other.run(20000);
    EXPECT_TRUE(one.is_finished() && other.is_finished()) << "seed " << seed;
    EXPECT_NEAR(one.value(), other.value(), 1e-6) << "seed " << seed;
  }
}

TEST(TaskProperty, T21SmallWorldsArePlannedAsExhaustiveSearchPlansThem) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    bench::SrsWorldOptions options;
    options.least_sources = 2;
    options.most_sources = 3;
    options.most_agents = 2;
    const TaskProblem problem = bench::random_srs_task(seed, options);
    const auto all = bench::best_task_value(problem, bench::OraclePruning::None, 400'000);
    if (!all.is_complete) continue;
    const auto pruned = bench::best_task_value(problem, bench::OraclePruning::Bound, 400'000);
    EXPECT_NEAR(pruned.value, all.value, 1e-6) << "seed " << seed;
    TaskPlanner planner{problem, Rng{seed}};
    planner.run(3000);
    EXPECT_NEAR(planner.value(), all.value, 1e-6) << "seed " << seed;
    EXPECT_GE(planner.upper_bound(), all.value - 1e-6) << "seed " << seed;
  }
}

TEST(TaskProperty, T23AnEditedWorldIsPlannedLikeANewOne) {
  // A second door with 20 in it at (0, 3), which the key opens too; then the first door goes.
  TaskProblem edited = key_and_door();
  ASSERT_FALSE(add_source(edited.world, spot("vault", 0.0, 3.0, 20.0)));
  ASSERT_FALSE(add_relation(edited.world, strict("key", "vault")));
  ASSERT_TRUE(remove_source(edited.world, "door"));
  const TaskProblem fresh =
      task_of({task_agent("a", 0.0, 0.0)}, {spot("key", 2.0, 0.0, 1.0), spot("vault", 0.0, 3.0, 20.0)},
              {strict("key", "vault")}, 20.0);
  const auto replanned = plan_task(edited, 500, Rng{1});
  const auto planned = plan_task(fresh, 500, Rng{1});
  ASSERT_TRUE(replanned && planned);
  EXPECT_EQ(replanned->value, planned->value);
  EXPECT_EQ(visits_of(edited, *replanned, 0), "key vault");
  EXPECT_EQ(replanned->agents[0].visits, planned->agents[0].visits);
}

TEST(TaskProperty, T23ABatteryThatRunsOutLimitsTheWay) {
  // 5 m out for 3, or 9 m out for 8: with 6 s of battery only the near one.
  TaskProblem problem =
      task_of({task_agent("drone", 0.0, 0.0)}, {spot("near", 5.0, 0.0, 3.0), spot("far", -9.0, 0.0, 8.0)}, {}, 60.0);
  const auto full = plan_task(problem, 500, Rng{1});
  ASSERT_TRUE(full);
  EXPECT_NEAR(full->value, 11.0, 1e-9);
  problem.agents[0].searcher.endurance_s = 6.0;
  const auto low = plan_task(problem, 500, Rng{1});
  ASSERT_TRUE(low);
  EXPECT_EQ(visits_of(problem, *low, 0), "near");
  EXPECT_NEAR(low->value, 3.0, 1e-9);
  EXPECT_LE(low->agents[0].end_s, 6.0);
}

TEST(TaskProperty, T23APersonWhoDeviatesIsPlannedForFromWhereItIs) {
  // a1 went the other way and is now 8 m from the switch: a0, 5.39 m from it, does both.
  TaskProblem problem = light_and_panel();
  problem.agents[1].start = {-6.0, 5.0, 0.0};
  problem.horizon_s = 40.0;
  const auto plan = plan_task(problem, 2000, Rng{1});
  ASSERT_TRUE(plan);
  EXPECT_NEAR(plan->value, 11.0, 1e-9);
  // Mate at the switch after 8 s, panel then open: better than a0 alone (11.2 s).
  EXPECT_NEAR(plan->makespan_s, 8.0, kClose);
  problem.agents[1].start = {-12.0, 5.0, 0.0};
  const auto alone = plan_task(problem, 2000, Rng{1});
  ASSERT_TRUE(alone);
  EXPECT_EQ(visits_of(problem, *alone, 0), "switch panel");
}

TEST(TaskProperty, T24ScalingAllRewardsChangesNoPlan) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const TaskProblem problem = bench::random_srs_task(seed);
    TaskProblem scaled = problem;
    for (RewardSource& source : scaled.world.sources) {
      source.inside.boundary_per_s *= 4.0;
      source.pool *= 4.0;
    }
    const auto one = plan_task(problem, 300, Rng{seed});
    const auto other = plan_task(scaled, 300, Rng{seed});
    ASSERT_TRUE(one && other);
    EXPECT_NEAR(other->value, 4.0 * one->value, 1e-6) << "seed " << seed;
  }
}

TEST(TaskProperty, T24TurningTheWorldTurnsThePlan) {
  // A quarter turn: (x, y) becomes (-y, x).
  const TaskProblem problem = light_and_panel();
  TaskProblem turned = problem;
  const auto turn = [](const Vector2d& p) { return Vector2d{-p.y(), p.x()}; };
  for (TaskAgent& agent : turned.agents) {
    const Vector2d start = turn(agent.start.position());
    agent.start = {start.x(), start.y(), 0.0};
  }
  for (RewardSource& source : turned.world.sources) {
    auto& disc = std::get<Disc>(source.boundary);
    disc.centre = turn(disc.centre);
  }
  const auto one = plan_task(problem, 500, Rng{1});
  const auto other = plan_task(turned, 500, Rng{1});
  ASSERT_TRUE(one && other);
  EXPECT_NEAR(one->makespan_s, other->makespan_s, 1e-3);
  for (std::size_t a = 0; a < 2; ++a) {
    EXPECT_EQ(visits_of(problem, *one, a), visits_of(turned, *other, a));
    const Vector2d end = turn(one->agents[a].path.points.back().point_in_map);
    EXPECT_NEAR((other->agents[a].path.points.back().point_in_map - end).norm(), 0.0, 1e-9);
  }
}

TEST(TaskProperty, T24TwiceTheSpeedTakesHalfTheTime) {
  TaskProblem problem = key_and_door();
  problem.agents[0].searcher.speed_mps = 2.0;
  const auto plan = plan_task(problem, 500, Rng{1});
  ASSERT_TRUE(plan);
  EXPECT_EQ(visits_of(problem, *plan, 0), "key door");
  EXPECT_NEAR(plan->makespan_s, 3.0, kClose);
}

}  // namespace
}  // namespace tandem
