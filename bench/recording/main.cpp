// `./run bench recording`: what recording and replay keep and cost, beside their targets.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "bench/recording/damage.hpp"
#include "bench/recording/live_recorder.hpp"
#include "bench/recording/report.hpp"
#include "bench/recording/seek.hpp"
#include "services/common/file_io.hpp"
#include "services/common/format.hpp"

namespace {

struct Arguments {
  std::string programs;
  std::string check;  ///< the command that reads our files with other people's libraries
  std::string output;
  double seconds = 600.0;
  int kills = 200;
  double replay_s = 60.0;
  std::uint64_t seek_mb = 1000;
  std::size_t cut_step = 1;
  std::size_t flips = 1000;
};

void run(const Arguments& arguments) {
  using namespace tandem::bench;
  using tandem::formatted;
  const Programs programs{arguments.programs};
  std::vector<RecordingRow> rows;
  const auto add = [&rows](const std::string& target, const std::string& measured, bool is_met) {
    rows.push_back({target, measured, is_met});
    std::fprintf(stderr, "%s: %s: %s\n", target.c_str(), measured.c_str(), is_met ? "met" : "missed");
  };

  const LoadResult load = record_under_load(programs, arguments.seconds);
  add("0 messages lost at 10 MB/s and 5000 messages/s",
      formatted("%llu of %llu lost in %.0f s at %.1f MB/s", static_cast<unsigned long long>(load.sent - load.recorded),
                static_cast<unsigned long long>(load.sent), arguments.seconds, load.megabytes_per_s),
      load.recorded == load.sent);
  add("at most 15 % of a core", formatted("%.1f %%", 100.0 * load.cpu_share), load.cpu_share <= 0.15);
  const KillResult kills = kill_recorders(programs, arguments.kills);
  add("kill -9 loses at most 1 record, the file opens without repair",
      formatted("%d kills: %d files with damage, %d with a gap", kills.killed, kills.unreadable, kills.gaps),
      kills.unreadable == 0 && kills.gaps == 0);
  const ReplayResult replay = replay_and_record(programs, arguments.replay_s);
  add("replay lateness p99 at most 3 ms at rate 1",
      formatted("p99 %.2f ms, longest %.2f ms, %llu messages", replay.lateness_p99_ms, replay.lateness_max_ms,
                static_cast<unsigned long long>(replay.messages)),
      replay.lateness_p99_ms <= 3.0);
  add("record, replay, record: the same payloads",
      replay.is_same_again ? "the same"
                           : formatted("not the same, %llu are missing", static_cast<unsigned long long>(replay.lost)),
      replay.is_same_again);
  const double seek = seek_s(arguments.seek_mb);
  add("seek in 1 GB within 1 s",
      formatted("%.2f s in %llu MB", seek, static_cast<unsigned long long>(arguments.seek_mb)), seek <= 1.0);
  const DamageResult cuts = cut_everywhere(arguments.cut_step);
  add("cut anywhere, all whole chunks and records are read",
      formatted("%zu cuts, %zu with a loss", cuts.tried, cuts.failed), cuts.failed == 0);
  const DamageResult flips = flip_bits(arguments.flips);
  add("bit flips cost only what they hit", formatted("%zu files, %zu with a loss", flips.tried, flips.failed),
      flips.failed == 0);
  if (!arguments.check.empty()) {
    const bool is_read = std::system((arguments.check + " >&2").c_str()) == 0;
    add("opens in @mcap/core and decodes with @foxglove/omgidl-serialization", is_read ? "all topics" : "it does not",
        is_read);
  }

  const std::filesystem::path output = arguments.output;
  std::filesystem::create_directories(output);
  tandem::write_file_atomically(output / "REPORT.md", recording_report(rows, report_head("./run bench recording")));
  std::printf("%s\nThe report is %s.\n", recording_table(rows).c_str(), (output / "REPORT.md").c_str());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"The benchmark of recording and replay"};
  Arguments arguments;
  app.add_option("--programs", arguments.programs, "Folder of tandem and tandem-recorder")->required();
  app.add_option("--check", arguments.check, "Command that reads our files with other people's libraries");
  app.add_option("--output", arguments.output, "Folder for REPORT.md")->required();
  app.add_option("--seconds", arguments.seconds, "Length of the load")->capture_default_str();
  app.add_option("--kills", arguments.kills, "Recorders to kill")->capture_default_str();
  app.add_option("--replay-seconds", arguments.replay_s, "Length of the recording that is replayed")
      ->capture_default_str();
  app.add_option("--seek-mb", arguments.seek_mb, "Size of the recording in which is sought")->capture_default_str();
  app.add_option("--cut-step", arguments.cut_step, "Cut at every N-th byte")->capture_default_str();
  app.add_option("--flips", arguments.flips, "Damaged files of each kind")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    run(arguments);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tandem-bench-recording: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
