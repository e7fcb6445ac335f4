#include "services/experiment/core/report/role_timeline.hpp"

#include <gtest/gtest.h>

namespace tandem::experiment {
namespace {

using State = PlanAt::State;

EpisodeLog episode_with(double duration_s, std::initializer_list<std::pair<double, Role>> plans) {
  EpisodeLog log;
  log.duration_s = duration_s;
  for (const auto& [time_s, role] : plans)
    log.plans.push_back({.time_s = time_s, .state = State::Proposed, .role = role});
  return log;
}

TEST(RoleSpans, LastFromTheFirstPlanToTheEnd) {
  const auto spans = role_spans(
      episode_with(100.0, {{4.0, Role::LeaderFollower}, {20.0, Role::LeaderFollower}, {40.0, Role::PeerPeer}}));
  ASSERT_EQ(spans.size(), 2U);
  EXPECT_DOUBLE_EQ(spans[0].from_s, 4.0);
  EXPECT_DOUBLE_EQ(spans[0].to_s, 40.0);
  EXPECT_EQ(spans[0].role, Role::LeaderFollower);
  EXPECT_DOUBLE_EQ(spans[1].to_s, 100.0);
  EXPECT_EQ(spans[1].role, Role::PeerPeer);
}

TEST(RoleSpans, APlanThatIsWithdrawnChangesNoRole) {
  auto log = episode_with(100.0, {{0.0, Role::LeaderFollower}});
  log.plans.push_back({.time_s = 50.0, .state = State::Rejected, .role = Role::PeerPeer});
  log.plans.push_back({.time_s = 60.0, .state = State::Superseded, .role = Role::MasterSlave});
  EXPECT_EQ(role_spans(log).size(), 1U);
}

TEST(RoleShares, AreOfTheTimeWithAPlan) {
  const auto shares = role_shares(
      episode_with(110.0, {{10.0, Role::LeaderFollower}, {35.0, Role::MasterSlave}, {85.0, Role::LeaderLeader}}));
  EXPECT_DOUBLE_EQ(shares[0], 0.25);
  EXPECT_DOUBLE_EQ(shares[1], 0.0);
  EXPECT_DOUBLE_EQ(shares[2], 0.5);
  EXPECT_DOUBLE_EQ(shares[3], 0.25);
  EXPECT_DOUBLE_EQ(role_shares(episode_with(10.0, {}))[0], 0.0);
}

TEST(RolesOverTime, CountOnlyWhatGoesOn) {
  const auto a = episode_with(25.0, {{5.0, Role::LeaderFollower}});
  const auto b = episode_with(10.0, {{0.0, Role::PeerPeer}});
  const std::vector<const EpisodeLog*> both{&a, &b};
  const auto moments = roles_over_time(both, 10.0);
  ASSERT_EQ(moments.size(), 3U);  // at 0, 10, 20 s
  EXPECT_EQ(moments[0].ongoing, 2U);
  EXPECT_EQ(moments[0].in, (std::array<std::size_t, 4>{0, 1, 0, 0}));  // a has no plan yet
  EXPECT_EQ(moments[1].ongoing, 1U);                                   // b ends at 10 s
  EXPECT_EQ(moments[1].in, (std::array<std::size_t, 4>{1, 0, 0, 0}));
  EXPECT_EQ(moments[2].ongoing, 1U);
}

}  // namespace
}  // namespace tandem::experiment
