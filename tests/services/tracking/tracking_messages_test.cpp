#include "services/tracking/tracking_messages.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tandem::tracking {
namespace {

TEST(TrackingMessages, TakeAScanAsItIs) {
  msg::LaserScan message;
  message.stamp_ns(1'000'000'000);
  message.angle_min_rad(-1.0);
  message.angle_increment_rad(0.5);
  message.beam_interval_s(0.25);
  message.range_max_m(30.0);
  message.ranges_m({1.0F, 2.0F, 3.0F});
  message.base_from_laser().x(0.16);
  const LaserScan scan = laser_scan(message);
  EXPECT_EQ(scan.ranges_m.size(), 3u);
  EXPECT_EQ(to_stamp_ns(scan.end()), 1'500'000'000);  // two beams after the first
  EXPECT_EQ(scan.base_from_laser.x, 0.16);
}

TEST(TrackingMessages, AMapThatContradictsItselfIsRefused) {
  msg::OccupancyGrid message;
  message.resolution_m(0.1);
  message.width(2);
  message.height(2);
  message.cells({0, 100, 255, 0});
  const auto grid = occupancy_grid(message);
  ASSERT_TRUE(grid);
  EXPECT_TRUE(grid->is_occupied({1, 0}));
  EXPECT_EQ(grid->at(CellIndex{0, 1}), CellState::Unknown);
  message.height(3);
  EXPECT_FALSE(occupancy_grid(message));
  message.height(0);
  message.cells({});
  EXPECT_FALSE(occupancy_grid(message));
}

TEST(TrackingMessages, ALostPosePlacesNothing) {
  msg::RobotPose message;
  message.status(msg::LOCALIZATION_UNCERTAIN);
  EXPECT_TRUE(usable_pose(message));
  message.map_from_base().y(std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(usable_pose(message));
  message.map_from_base().y(0.0);
  message.status(msg::LOCALIZATION_LOST);
  EXPECT_FALSE(usable_pose(message));
}

TEST(TrackingMessages, OnlyAnAcceptedPlanIsAHint) {
  msg::TeamPlan plan;
  msg::PlannedPath path;
  path.agent("person1");
  msg::TimedPoint point;
  point.x_m(1.0);
  path.points({point});
  plan.paths({path});
  plan.state(msg::PLAN_PROPOSED);
  EXPECT_TRUE(accepted_path(plan, "person1").empty());
  plan.state(msg::PLAN_ACCEPTED);
  EXPECT_EQ(accepted_path(plan, "person1").size(), 1u);
  EXPECT_TRUE(accepted_path(plan, "person2").empty());
}

TEST(TrackingMessages, SayWhereTheTeammateIsAndHowSure) {
  TeammateEstimate estimate;
  estimate.stamp = from_stamp_ns(5);
  estimate.map_from_agent = {1.0, 2.0, 0.5};
  estimate.velocity_in_map_mps = {0.3, -0.4};
  estimate.standard_deviation_m = 0.5;
  estimate.source = Source::Laser;
  estimate.lost = true;
  estimate.age_s = 11.0;
  const msg::TeammateState message = teammate_state(estimate, "person1", "robot1");
  EXPECT_EQ(message.agent(), "person1");
  EXPECT_EQ(message.map_from_agent().y(), 2.0);
  EXPECT_EQ(message.covariance()[4], 0.25);
  EXPECT_EQ(message.velocity().left_mps(), -0.4);
  EXPECT_EQ(message.source(), msg::SOURCE_LASER);
  EXPECT_EQ(message.state(), msg::TRACK_LOST);
}

TEST(TrackingMessages, PeopleAreThoseWhoShowedBothLegsOrWalked) {
  Track person;
  person.id = 7;
  person.person = true;
  person.motion.mean << 1.0, 2.0, 0.5, 0.0;
  const msg::TrackedPeople message = tracked_people({person, Track{}}, "robot1", from_stamp_ns(5), {3.0, 4.0, 0.0});
  ASSERT_EQ(message.people().size(), 1u);
  EXPECT_EQ(message.people()[0].track_id(), 7u);
  EXPECT_EQ(message.people()[0].velocity_in_map_mps().x(), 0.5);
  EXPECT_EQ(message.map_from_base().x(), 3.0);
}

}  // namespace
}  // namespace tandem::tracking
