#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "services/planner/core/search/search_belief.hpp"
#include "services/planner/core/team/planner.hpp"
#include "tests/services/planner/support/room.hpp"

namespace tandem {

/// The area that can be walked to from there.
inline SearchAreaOptions start_at(double x, double y) {
  SearchAreaOptions options;
  options.start_in_map = {x, y};
  return options;
}

inline Searcher test_robot() {
  Searcher robot;
  robot.id = "robot";
  robot.speed_mps = 0.5;
  robot.radius_m = 0.45;
  robot.preferred_clearance_m = 0.8;
  robot.view_min_m = 0.6;
  robot.view_max_m = 4.0;
  robot.field_of_view_rad = from_degrees(60.0);
  robot.detection_rate_per_s = 1.0;
  return robot;
}

inline Searcher test_person() {
  Searcher person;
  person.id = "person";
  person.speed_mps = 0.75;
  person.radius_m = 0.25;
  return person;
}

/// A search by agents who all start at one place, with a uniform prior.
class SearchCase {
 public:
  SearchCase(OccupancyGrid map, const Eigen::Vector2d& start_in_map, std::vector<Searcher> searchers,
             double lookout_range_m = 2.5)
      : world_(std::make_unique<SearchWorld>(std::vector{std::move(map)},
                                             options(start_in_map, std::move(searchers), lookout_range_m))) {
    problem.world = world_.get();
    for (std::size_t i = 0; i < world_->searchers().size(); ++i) {
      SearchMember member;
      member.searcher = static_cast<int>(i);
      member.pose = {start_in_map.x(), start_in_map.y(), 0.0};
      problem.members.push_back(member);
    }
    problem.masses = {uniform_prior(world_->area(), start_in_map, 0.0)};
    problem.horizon_s = 100.0;
  }

  [[nodiscard]] SearchWorld& world() { return *world_; }

 private:
  static SearchWorldOptions options(const Eigen::Vector2d& start_in_map, std::vector<Searcher> searchers,
                                    double lookout_range_m) {
    SearchWorldOptions options;
    options.area = start_at(start_in_map.x(), start_in_map.y());
    options.lookout_range_m.assign(searchers.size(), lookout_range_m);
    options.searchers = std::move(searchers);
    return options;
  }
  std::unique_ptr<SearchWorld> world_;

 public:
  SearchProblem problem;
};

/// The plan of a planner after so many rollouts.
inline JointPlan plan_with(Planner& planner, const SearchProblem& problem, int rollouts, std::uint64_t seed) {
  planner.begin(problem, Rng{seed});
  planner.run(rollouts, {});
  return planner.best();
}

}  // namespace tandem
