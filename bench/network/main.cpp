// tandem-bench-network: our link beside Fast DDS's defaults; see docs/network.md.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>

#include "bench/network/campaign.hpp"
#include "bench/network/report.hpp"
#include "bench/planning/records/resumable.hpp"
#include "bench/planning/report/run_info.hpp"
#include "services/common/clock.hpp"
#include "services/common/stop_signal.hpp"
#include "services/common/version.hpp"

namespace {

using namespace tandem;
using namespace tandem::bench;

struct AllOptions {
  std::filesystem::path output;
  int runs = 5;
  int threads = 4;
  bool quick = false;
};

/// Makes what is missing: several at a time, and then, one by one, those that want to be alone.
std::vector<NetworkRecord> measured(const std::vector<NetworkRequest>& requests, const AllOptions& options,
                                    const StopSignal& stop) {
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  std::vector<NetworkRecord> records;
  for (const bool alone : {false, true}) {
    std::vector<NetworkRequest> part;
    std::copy_if(requests.begin(), requests.end(), std::back_inserter(part),
                 [alone](const auto& request) { return request.alone == alone; });
    PartProgress progress(alone ? "network, whole teams" : "network");
    const auto made = resumed<NetworkRecord>(
        part,
        [&](const NetworkRequest& request) { return measured_apart(request, program, options.output / "cells.log"); },
        [&](const NetworkRecord& record, std::size_t left) { progress.show(record.key.text(), left); },
        RunControl{options.output / "runs.jsonl", alone ? 1 : options.threads, [&] { return stop.requested(); }});
    records.insert(records.end(), made.begin(), made.end());
  }
  return records;
}

int run_all(const AllOptions& options) {
  std::filesystem::create_directories(options.output);
  const StopSignal stop;
  const int runs = options.quick ? 1 : options.runs;
  const auto records = measured(network_campaign(runs, options.quick), options, stop);
  std::string command = "./run bench network";
  if (options.quick) command += " --quick";
  for (const auto& [name, content] :
       network_report(records, {date_of(SteadyClock{}.now()), commit(), machine(), command})) {
    write_file_atomically(options.output / name, content);
  }
  std::printf("%s\nThe report is %s.\n", network_targets(records).c_str(), (options.output / "REPORT.md").c_str());
  if (stop.requested()) std::printf("Stopped early; the same command goes on.\n");
  return stop.requested() ? 130 : 0;
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app{"The network benchmark"};
  app.require_subcommand(1);
  AllOptions options;
  auto* all = app.add_subcommand("all", "Everything, and a report; goes on where it was stopped");
  all->add_option("--output", options.output, "Folder of results and report")->required();
  all->add_option("--runs", options.runs, "Of each measurement")->check(CLI::Range(1, 100))->capture_default_str();
  all->add_option("--threads", options.threads, "Measurements at a time: most of each is waiting")
      ->check(CLI::Range(1, 16))
      ->capture_default_str();
  all->add_flag("--quick", options.quick, "One run, fewer airs: about 12 minutes");
  NetworkKey key;
  auto* cell = app.add_subcommand("cell", "One measurement, printed as JSON");
  cell->add_option("what", key.what)->required();
  cell->add_option("whose", key.whose)->required()->check(CLI::IsMember({"ours", "secured", "default"}));
  cell->add_option("air", key.air)->required();
  cell->add_option("run", key.run)->required();
  CLI11_PARSE(app, argc, argv);
  if (cell->parsed()) {
    std::printf("%s\n", text_of(measured_here(key)).c_str());
    return EXIT_SUCCESS;
  }
  return run_all(options);
} catch (const std::exception& error) {
  std::fprintf(stderr, "tandem-bench-network: %s\n", error.what());
  return EXIT_FAILURE;
}
