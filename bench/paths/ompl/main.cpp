// tandem-bench-paths-ompl PLANNER SEED BUDGET_MS ...: how short the way is that a planner of OMPL finds within each
// budget of processor time. The question comes on standard input, see bench/paths/ompl_peer.hpp; a length of 0 says
// that there is no way yet.
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/LazyPRMstar.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

#include "services/mapping/core/ray_casting.hpp"

namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kRange_m = 2.0;  ///< of the trees' steps

/// Of all threads of this process.
double cpu_ms() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

Eigen::Vector2d point_of(const ob::State* state) {
  const auto* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
  return {values[0], values[1]};
}

/// Straight lines, tested exactly: what our own reference does.
class Lines final : public ob::MotionValidator {
 public:
  Lines(const ob::SpaceInformationPtr& space, const tandem::OccupancyGrid& room)
      : ob::MotionValidator(space), room_(room) {}
  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return tandem::line_of_sight(room_, point_of(from), point_of(to));
  }
  /// How far it is free, to half a cell: PRM* bounces off walls.
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last_free) const override {
    if (checkMotion(from, to)) return true;
    const Eigen::Vector2d begin = point_of(from);
    const Eigen::Vector2d line = point_of(to) - begin;
    const double step = 0.5 * room_.resolution_m() / std::max(line.norm(), room_.resolution_m());
    last_free.second = 0.0;
    while (tandem::line_of_sight(room_, begin, begin + (last_free.second + step) * line)) last_free.second += step;
    if (last_free.first != nullptr) si_->getStateSpace()->interpolate(from, to, last_free.second, last_free.first);
    return false;
  }

 private:
  const tandem::OccupancyGrid& room_;
};

ob::PlannerPtr planner_of(const std::string& name, const ob::SpaceInformationPtr& space) {
  if (name == "RRTstar" || name == "InformedRRTstar") {
    const auto planner =
        name == "RRTstar" ? std::make_shared<og::RRTstar>(space) : std::make_shared<og::InformedRRTstar>(space);
    planner->setRange(kRange_m);
    return planner;
  }
  if (name == "BITstar") return std::make_shared<og::BITstar>(space);
  if (name == "ABITstar") return std::make_shared<og::ABITstar>(space);
  if (name == "PRMstar") return std::make_shared<og::PRMstar>(space);
  if (name == "LazyPRMstar") return std::make_shared<og::LazyPRMstar>(space);
  throw std::invalid_argument{"no planner is called " + name};
}

tandem::OccupancyGrid read_room() {
  int width = 0;
  int height = 0;
  double resolution_m = 0.0;
  tandem::Pose2 corner;
  if (!(std::cin >> width >> height >> resolution_m >> corner.x >> corner.y)) throw std::invalid_argument{"no map"};
  tandem::OccupancyGrid room{width, height, resolution_m, corner, tandem::CellState::Occupied};
  std::string line;
  for (int row = 0; row < height && std::cin >> line; ++row) {
    for (int column = 0; column < width; ++column) {
      if (line.at(static_cast<std::size_t>(column)) == '.') room.set({column, row}, tandem::CellState::Free);
    }
  }
  return room;
}

void answer(const std::string& planner_name, int budgets, char** budgets_ms) {
  const tandem::OccupancyGrid room = read_room();
  const auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0, room.map_from_grid().x);
  bounds.setLow(1, room.map_from_grid().y);
  bounds.setHigh(0, room.map_from_grid().x + room.width() * room.resolution_m());
  bounds.setHigh(1, room.map_from_grid().y + room.height() * room.resolution_m());
  plane->setBounds(bounds);
  const auto space = std::make_shared<ob::SpaceInformation>(plane);
  space->setStateValidityChecker(
      [&](const ob::State* state) { return room.at(point_of(state)) == tandem::CellState::Free; });
  space->setMotionValidator(std::make_shared<Lines>(space, room));
  space->setup();
  ob::ScopedState<ob::RealVectorStateSpace> start(plane);
  ob::ScopedState<ob::RealVectorStateSpace> goal(plane);
  if (!(std::cin >> start[0] >> start[1] >> goal[0] >> goal[1])) throw std::invalid_argument{"no start and goal"};
  const auto problem = std::make_shared<ob::ProblemDefinition>(space);
  problem->setStartAndGoalStates(start, goal);
  problem->setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(space));

  const double begin_ms = cpu_ms();
  const ob::PlannerPtr planner = planner_of(planner_name, space);
  planner->setProblemDefinition(problem);
  planner->setup();
  for (int i = 0; i < budgets; ++i) {
    const double budget_ms = std::stod(budgets_ms[i]);
    planner->solve(ob::PlannerTerminationCondition([&] { return cpu_ms() - begin_ms >= budget_ms; }));
    const double length_m = problem->hasExactSolution() ? problem->getSolutionPath()->length() : 0.0;
    std::printf("%s %.6f\n", budgets_ms[i], length_m);
  }
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 4) throw std::invalid_argument{"PLANNER SEED BUDGET_MS ... are needed"};
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(std::stoul(argv[2])));
  answer(argv[1], argc - 3, argv + 3);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "tandem-bench-paths-ompl: %s\n", error.what());
  return 1;
}
