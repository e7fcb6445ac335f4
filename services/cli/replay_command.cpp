#include "services/cli/replay_command.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "services/cli/command.hpp"
#include "services/cli/host_bus.hpp"
#include "services/cli/progress.hpp"
#include "services/common/file_io.hpp"
#include "services/localization/core/trajectory_file.hpp"
#include "services/recorder/player.hpp"

namespace tandem::cli {
namespace {

struct ReplayCommandOptions {
  std::string file;
  std::string rate = "1";
  std::string trajectory;
  HostOptions host;
  recorder::ReplayOptions replay;
};

double rate_of(const std::string& text) {
  if (text == "max") return 0.0;
  try {
    std::size_t used = 0;
    const double rate = std::stod(text, &used);
    if (used == text.size() && rate > 0.0 && rate <= 1000.0) return rate;
  } catch (const std::logic_error&) {  // not a number: as said below
  }
  throw WrongUse("replay: --rate is a number above 0, or max: " + text);
}

TimedPose timed(const msg::RobotPose& message) {
  const msg::Pose& pose = message.map_from_base();
  return {from_stamp_ns(message.stamp_ns()), {pose.x(), pose.y(), pose.heading()}};
}

void run(ReplayCommandOptions options) {
  (void)stop_requested();  // from here on Ctrl-C is asked for
  options.replay.rate = rate_of(options.rate);
  if (!options.trajectory.empty() && !options.replay.lockstep) throw WrongUse("replay: --trajectory needs --lockstep");
  if (options.replay.lockstep && options.replay.loop)
    throw WrongUse("replay: --lockstep and --loop exclude each other");

  mcap::Reader reader{mcap::file_source(options.file), options.file};
  bus::Bus bus{bus::host_domain(site_of(options.host), "replay",
                                options.replay.lockstep ? bus::Pace::Lockstep : bus::Pace::RealTime)};
  recorder::Player player{reader, bus, options.replay};
  Progress progress{"replay"};
  std::string trajectory;
  const std::uint64_t sent = player.play(
      [&progress](double share) {
        progress.show(share);
        return !stop_requested();
      },
      [&trajectory](const msg::RobotPose& pose) {
        const bool is_known = !pose.hypotheses().empty();  // else the scan's answer is that there is no pose
        if (is_known) trajectory += trajectory_line(timed(pose));
      });
  if (stop_requested()) throw Interrupted{};
  if (!options.trajectory.empty()) write_file_atomically(options.trajectory, trajectory);
  std::fprintf(stderr, "%s: %llu messages sent\n", options.file.c_str(), static_cast<unsigned long long>(sent));
  for (const std::string& damage : reader.damages()) std::fprintf(stderr, "tandem: %s\n", damage.c_str());
  if (!reader.damages().empty()) throw Failed{};
}

}  // namespace

void add_replay_command(CLI::App& tandem) {
  const auto options = std::make_shared<ReplayCommandOptions>();
  CLI::App* command = add_command(tandem, "replay", "Send a recording's messages again, with its time as the clock",
                                  "tandem replay episode.mcap --rate 2 --topics odometry,scan");
  command->add_option("FILE", options->file, "Recording (.mcap)")->required();
  command->add_option("--rate", options->rate, "Recorded seconds per second, or max")->capture_default_str();
  command->add_option("--from", options->replay.from_s, "Begin this many seconds into it")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--topics", options->replay.topics, "Only these, separated by commas")->delimiter(',');
  command->add_flag("--loop", options->replay.loop, "Again and again");
  command->add_flag("--lockstep", options->replay.lockstep, "Wait for localization's pose after each scan");
  command->add_option("--trajectory", options->trajectory, "With --lockstep: write the poses as lines of t x y theta");
  command->add_option("--config", options->host.config_folder, "Folder with site.toml")->capture_default_str();
  command->add_option("--domain", options->host.domain, "DDS domain, instead of the site's");
  command->callback([options] { run(*options); });
}

}  // namespace tandem::cli
