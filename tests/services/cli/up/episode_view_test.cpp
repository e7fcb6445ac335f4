#include "services/cli/up/episode_view.hpp"

#include <gtest/gtest.h>

namespace tandem::cli {
namespace {

EpisodeView some_view() {
  EpisodeView view;
  view.phase = "searching";
  view.time_s = 65.0;
  view.limit_s = 600.0;
  view.explored = 0.5;
  view.explored_robot = 0.2;
  view.explored_human = 0.3;
  view.map = OccupancyGrid{40, 20, 0.5, Pose2{}, CellState::Free};
  view.robot_track = {{1.0, 1.0}, {5.0, 5.0}};
  view.human_track = {{1.0, 2.0}};
  return view;
}

TEST(EpisodeView, TellsTimeSharesAndDistanceInWords) {
  const auto lines = lines_of(some_view(), 80, 0);
  std::string text;
  for (const auto& line : lines) text += line + "\n";

  EXPECT_NE(text.find("1:05 of 10:00"), std::string::npos);
  EXPECT_NE(text.find("50 %"), std::string::npos);
  EXPECT_NE(text.find("robot   20 %"), std::string::npos);
  EXPECT_NE(text.find("person  30 %"), std::string::npos);
}

TEST(EpisodeView, TheLiveMapKeepsToItsRows) {
  const auto without = lines_of(some_view(), 80, 0).size();
  EXPECT_LE(lines_of(some_view(), 80, 12).size(), without + 12 + 1);  // and its legend
  EXPECT_GT(lines_of(some_view(), 80, 12).size(), without);
}

TEST(EpisodeView, BecomesAPng) { EXPECT_EQ(picture_of(some_view()).substr(1, 3), "PNG"); }

TEST(EpisodeView, APictureOfNothingIsAPngToo) { EXPECT_EQ(picture_of(EpisodeView{}).substr(1, 3), "PNG"); }

}  // namespace
}  // namespace tandem::cli
