// tandem-bench-paths: how good the ways of our motion are, beside OMPL's planners; see bench/paths/README.md.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "bench/paths/ompl_peer.hpp"
#include "bench/paths/own_ways.hpp"
#include "bench/paths/report.hpp"
#include "bench/planning/loop/run_plan.hpp"
#include "bench/planning/records/json_lines.hpp"
#include "services/common/file_io.hpp"

namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::vector<std::string> families{"S1u", "S2r2", "S2p2"};
  std::string seeds = "1:10";
  std::vector<double> budgets_ms{10.0, 50.0, 200.0, 1000.0};
  std::string output;
};

void run(const Arguments& arguments, const fs::path& ompl) {
  using namespace tandem::bench;
  std::vector<PathRecord> records;
  for (const std::string& family : arguments.families) {
    for (const std::uint64_t seed : parse_seeds(arguments.seeds)) {
      const PathCase one = path_case(family, seed);
      std::fprintf(stderr, "%s %llu: shortest way %.2f m\n", family.c_str(), static_cast<unsigned long long>(seed),
                   one.shortest_m);
      for (PathRecord& record : own_ways(one)) records.push_back(record);
      if (!fs::exists(ompl)) continue;
      for (const std::string& planner : ompl_planners()) {
        for (PathRecord& record : ompl_ways(ompl, one, planner, arguments.budgets_ms)) records.push_back(record);
      }
    }
  }
  std::string lines;
  for (const PathRecord& record : records) lines += to_line(record) + "\n";
  const fs::path output = arguments.output;
  fs::create_directories(output);
  tandem::write_file_atomically(output / "paths.jsonl", lines);
  for (const auto& [name, content] : paths_report(records, report_head("./run bench paths"))) {
    tandem::write_file_atomically(output / name, content);
  }
  std::printf("The report is %s.\n", (output / "REPORT.md").c_str());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"The benchmark of ways"};
  Arguments arguments;
  app.add_option("--family", arguments.families, "Families of planning instances")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--seeds", arguments.seeds, "Instances: 1:6 or 1,4,7:9")->capture_default_str();
  app.add_option("--budget-ms", arguments.budgets_ms, "Processor time of OMPL's planners, ascending")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--output", arguments.output, "Folder for REPORT.md")->required();
  CLI11_PARSE(app, argc, argv);
  try {
    run(arguments, fs::read_symlink("/proc/self/exe").parent_path() / "tandem-bench-paths-ompl");
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tandem-bench-paths: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
