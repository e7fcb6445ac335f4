#include "services/mapping/core/map_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "tests/support/ascii_map.hpp"

namespace tandem {
namespace {

/// A room of `width` x `height` cells with walls around.
std::vector<std::string> room(int width, int height) {
  std::vector<std::string> rows(static_cast<std::size_t>(height), "#" + std::string(width - 2, '.') + "#");
  rows.front() = rows.back() = std::string(width, '#');
  return rows;
}
bool says(const MapCheck& check, MapFault fault) {
  return std::any_of(check.findings.begin(), check.findings.end(),
                     [fault](const MapFinding& finding) { return finding.fault == fault; });
}
const MapFinding& finding_of(const MapCheck& check, MapFault fault) {
  return *std::find_if(check.findings.begin(), check.findings.end(),
                       [fault](const MapFinding& finding) { return finding.fault == fault; });
}

TEST(MapCheck, HasNothingToSayOfAPlainRoom) {
  const MapCheck check = check_map(test::ascii_map(room(100, 60), 0.1));
  EXPECT_TRUE(check.findings.empty());
  EXPECT_FALSE(has_faults(check));
  EXPECT_NEAR(check.summary.width_m, 10.0, 1e-9);
  EXPECT_NEAR(check.summary.free_m2, 98 * 58 * 0.01, 1e-9);
  EXPECT_NEAR(check.summary.widest_m, 5.8, 0.11);
}

TEST(MapCheck, NamesAMapInWhichNothingIsKnown) {
  const MapCheck check = check_map(OccupancyGrid{50, 50, 0.1});
  EXPECT_TRUE(says(check, MapFault::NothingKnown));
  EXPECT_TRUE(has_faults(check));
  EXPECT_TRUE(has_faults(check_map(OccupancyGrid{})));
}

TEST(MapCheck, NamesAMapWithoutFreeSpaceAndOneWithoutWalls) {
  EXPECT_TRUE(says(check_map(OccupancyGrid{50, 50, 0.1, {}, CellState::Occupied}), MapFault::NoFreeSpace));
  EXPECT_TRUE(says(check_map(OccupancyGrid{50, 50, 0.1, {}, CellState::Free}), MapFault::NoWalls));
}

TEST(MapCheck, NamesAResolutionThatIsTooSmall) {
  const MapCheck check = check_map(test::ascii_map(room(100, 60), 0.005));  // 0.5 m x 0.3 m
  EXPECT_TRUE(says(check, MapFault::TooSmall));
  EXPECT_TRUE(says(check, MapFault::NarrowSpace));
  EXPECT_TRUE(has_faults(check));
}

TEST(MapCheck, NamesAResolutionThatIsTooLarge) {
  EXPECT_TRUE(says(check_map(test::ascii_map(room(100, 60), 1.0)), MapFault::CellsTooLarge));
  EXPECT_TRUE(says(check_map(test::ascii_map(room(100, 60), 100.0)), MapFault::TooLarge));
}

TEST(MapCheck, WondersAboutThickWalls) {
  std::vector<std::string> rows = room(100, 60);
  for (std::size_t row = 1; row < 59; ++row) rows[row].replace(50, 9, "#########");
  rows[30].replace(50, 9, ".........");
  const MapCheck check = check_map(test::ascii_map(rows, 0.1));
  EXPECT_TRUE(says(check, MapFault::WallsTooThick));
  EXPECT_FALSE(has_faults(check));
}

TEST(MapCheck, SaysWhereAnUnknownAreaIs) {
  std::vector<std::string> rows = room(100, 60);
  for (std::size_t row = 20; row < 40; ++row) rows[row].replace(30, 20, std::string(20, '?'));
  const MapCheck check = check_map(test::ascii_map(rows, 0.1));
  ASSERT_TRUE(says(check, MapFault::UnknownAreas));
  EXPECT_EQ(finding_of(check, MapFault::UnknownAreas).where, "around (4.0, 3.0), 2.0 x 2.0 m");
  EXPECT_FALSE(has_faults(check));
}

TEST(MapCheck, NamesAMapOfWhichHardlyAnythingIsFree) {
  OccupancyGrid map{200, 200, 0.1};
  map.set({0, 0}, CellState::Occupied);
  map.set({199, 199}, CellState::Occupied);
  for (int i = 50; i < 60; ++i) {
    for (int k = 50; k < 60; ++k) map.set({i, k}, CellState::Free);
  }
  const MapCheck check = check_map(map);
  EXPECT_EQ(finding_of(check, MapFault::UnknownAreas).severity, Severity::Fault);
}

TEST(MapCheck, SaysThatRoomsDoNotHangTogether) {
  std::vector<std::string> rows = room(100, 60);
  for (std::string& row : rows) row[50] = '#';
  EXPECT_TRUE(says(check_map(test::ascii_map(rows, 0.1)), MapFault::TornSpace));
}

TEST(MapCheck, SaysThatFreeSpaceIsCutOff) {
  std::vector<std::string> rows = room(100, 60);
  rows[30][0] = '.';
  EXPECT_TRUE(says(check_map(test::ascii_map(rows, 0.1)), MapFault::OpenBorder));
}

TEST(MapCheck, PutsFaultsBeforeHints) {
  std::vector<std::string> rows = room(100, 60);
  rows[30][0] = '.';
  const MapCheck check = check_map(test::ascii_map(rows, 1.0));
  ASSERT_GE(check.findings.size(), 2U);
  EXPECT_EQ(check.findings.front().severity, Severity::Fault);
  EXPECT_EQ(check.findings.back().severity, Severity::Hint);
}

TEST(MapCheck, HasANameForEachFault) {
  std::set<std::string> names;
  for (int i = 0; i <= static_cast<int>(MapFault::OpenBorder); ++i) names.insert(name_of(static_cast<MapFault>(i)));
  EXPECT_EQ(names.size(), 12U);
}

}  // namespace
}  // namespace tandem
