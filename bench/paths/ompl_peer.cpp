#include "bench/paths/ompl_peer.hpp"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "services/common/file_io.hpp"
#include "services/common/format.hpp"

namespace tandem::bench {

const std::vector<std::string>& ompl_planners() {
  static const std::vector<std::string> names{"RRTstar",  "InformedRRTstar", "BITstar",
                                              "ABITstar", "PRMstar",         "LazyPRMstar"};
  return names;
}

std::string ompl_question(const PathCase& one) {
  const OccupancyGrid& room = one.room;
  const Pose2& corner = room.map_from_grid();
  std::string text =
      formatted("%d %d %.17g %.17g %.17g\n", room.width(), room.height(), room.resolution_m(), corner.x, corner.y);
  for (int row = 0; row < room.height(); ++row) {
    for (int column = 0; column < room.width(); ++column) text += room.is_free({column, row}) ? '.' : '#';
    text += '\n';
  }
  return text + formatted("%.17g %.17g %.17g %.17g\n", one.start_in_map.x(), one.start_in_map.y(), one.goal_in_map.x(),
                          one.goal_in_map.y());
}

std::vector<PathRecord> ompl_answer(const std::string& text, const PathCase& one, const std::string& planner,
                                    const std::vector<double>& budgets_ms) {
  std::istringstream lines(text);
  std::vector<PathRecord> records;
  for (const double budget_ms : budgets_ms) {
    PathRecord record{one.family, one.seed, "OMPL " + planner, 0.0, 0.0, 0.0, one.shortest_m};
    if (!(lines >> record.budget_ms >> record.length_m) || record.budget_ms != budget_ms) {
      throw std::runtime_error{"the OMPL program wrote no line for a budget of " + std::to_string(budget_ms) + " ms"};
    }
    records.push_back(record);
  }
  return records;
}

std::vector<PathRecord> ompl_ways(const std::filesystem::path& program, const PathCase& one, const std::string& planner,
                                  const std::vector<double>& budgets_ms) {
  const auto question = std::filesystem::temp_directory_path() / formatted("tandem_ompl_%d.txt", getpid());
  write_file_atomically(question, ompl_question(one));
  std::string command = program.string() + " " + planner + " " + std::to_string(one.seed);
  for (const double budget_ms : budgets_ms) command += formatted(" %g", budget_ms);
  std::string answer;
  {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe{popen((command + " <" + question.string()).c_str(), "r"),
                                                               pclose};
    if (!pipe) throw std::runtime_error{command + ": cannot be run"};
    std::array<char, 4096> buffer{};
    while (std::fgets(buffer.data(), buffer.size(), pipe.get()) != nullptr) answer += buffer.data();
  }
  std::filesystem::remove(question);
  return ompl_answer(answer, one, planner, budgets_ms);
}

}  // namespace tandem::bench
