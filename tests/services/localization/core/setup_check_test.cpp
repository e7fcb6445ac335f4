#include "services/localization/core/setup_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "services/localization/core/beams.hpp"
#include "services/localization/core/place_finder.hpp"
#include "tests/services/localization/room.hpp"

namespace tandem {
namespace {

/// A robot that drives a circle, and asks whether map and laser are what they should be.
class Drive {
 public:
  /// Drives in `room`, and knows it as `map`.
  Drive(OccupancyGrid room, OccupancyGrid map)
      : room_(std::move(room)),
        map_(std::move(map)),
        field_(map_, DistanceField{map_, 2.0}, {}),
        finder_(map_, field_, {}) {}

  void step() {
    const Pose2 motion{0.2, 0.0, 0.15};
    truth_ = truth_ * motion;
    odom_ = odom_ * motion;
    time_ += from_seconds(0.5);
    LaserScan scan = test::scan_from(room_, truth_, time_);
    if (mirrored_) std::reverse(scan.ranges_m.begin(), scan.ranges_m.end());
    const auto endpoints = selected_endpoints(scan, 90, 25.0, {});
    finder_.add({time_, odom_, {}, 0}, endpoints);
    check_.add({time_, odom_, {}, 0}, endpoints, scan.base_from_laser, finder_.way_m());
    finder_.seek();
    while (finder_.is_searching()) finder_.advance(100'000);
    for (int i = 0; i < 20; ++i) {
      check_.advance(finder_.map(), score_.value_or(finder_.finding().score), 100'000);
    }
  }
  void drive(int steps) {
    for (int i = 0; i < steps && !check_.fault(); ++i) step();
  }

  OccupancyGrid room_;
  OccupancyGrid map_;
  LikelihoodField field_;
  PlaceFinder finder_;
  SetupCheck check_{{}};
  bool mirrored_ = false;
  std::optional<double> score_;  ///< of the best place; none: as it is found
  Time time_{};
  Pose2 truth_{2.5, 1.2, 0.0};
  Pose2 odom_;
};

OccupancyGrid enlarged(const OccupancyGrid& room, double scale) {
  OccupancyGrid map{room.width(), room.height(), scale * room.resolution_m(), room.map_from_grid()};
  std::copy(room.cells().begin(), room.cells().end(), map.cells().begin());
  return map;
}

TEST(SetupCheck, FindsNothingWrongWhereNothingIs) {
  Drive drive{test::uneven_room(), test::uneven_room()};
  drive.drive(30);
  EXPECT_FALSE(drive.check_.fault());
}

TEST(SetupCheck, NamesALaserThatIsMountedUpsideDown) {
  Drive drive{test::uneven_room(), test::uneven_room()};
  drive.mirrored_ = true;
  drive.drive(30);
  EXPECT_EQ(drive.check_.fault(), InputFault::LaserMirrored);
}

TEST(SetupCheck, NamesAMapOfAnotherScale) {
  Drive drive{test::uneven_room(), enlarged(test::uneven_room(), 1.5)};
  drive.drive(40);
  EXPECT_EQ(drive.check_.fault(), InputFault::MapScaleWrong);
  EXPECT_NEAR(drive.check_.map_scale(), 1.5, 0.06);  // the next of the list are 5 % away
}

TEST(SetupCheck, KeepsItsWordWhereNothingTellsTheTwoApart) {
  Drive drive{test::uneven_room(), test::uneven_room()};
  drive.mirrored_ = true;
  drive.drive(30);
  ASSERT_TRUE(drive.check_.fault());
  // Places as things are set up seem to fit as well as the mirrored ones: no reason to believe in either.
  drive.score_ = 0.9;
  for (int i = 0; i < 20; ++i) drive.step();
  EXPECT_EQ(drive.check_.fault(), InputFault::LaserMirrored);
}

TEST(SetupCheck, TakesItsWordBackWhenTheEvidenceIsGone) {
  Drive drive{test::uneven_room(), test::uneven_room()};
  drive.mirrored_ = true;
  drive.drive(30);
  ASSERT_TRUE(drive.check_.fault());

  drive.mirrored_ = false;
  drive.check_.forget();
  drive.finder_.forget();  // as the localizer does, of what was seen with the other setup
  for (int i = 0; i < 20; ++i) drive.step();
  EXPECT_FALSE(drive.check_.fault());
}

}  // namespace
}  // namespace tandem
