#include "services/cli/replay_command.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "services/cli/command.hpp"
#include "services/cli/host_bus.hpp"
#include "services/cli/progress.hpp"
#include "services/cli/replay_keys.hpp"
#include "services/cli/terminal_keys.hpp"
#include "services/common/file_io.hpp"
#include "services/localization/core/trajectory_file.hpp"
#include "services/recorder/player.hpp"

namespace tandem::cli {
namespace {

struct ReplayCommandOptions {
  std::string file;
  std::string rate = "1";
  std::string trajectory;
  std::vector<std::string> renames;  ///< "recorded=sent"
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

std::map<std::string, std::string> renames_of(const std::vector<std::string>& words) {
  std::map<std::string, std::string> renames;
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    if (equals == 0 || equals == std::string::npos || equals + 1 == word.size()) {
      throw WrongUse("replay: --rename takes RECORDED=SENT: " + word);
    }
    renames[word.substr(0, equals)] = word.substr(equals + 1);
  }
  return renames;
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
  if (options.replay.until_s <= options.replay.from_s) throw WrongUse("replay: --until is not behind --from");
  options.replay.rename = renames_of(options.renames);

  mcap::Reader reader{mcap::file_source(options.file), options.file};
  bus::Bus bus{bus::host_domain(site_of(options.host), "replay",
                                options.replay.lockstep ? bus::Pace::Lockstep : bus::Pace::RealTime)};
  recorder::Player player{reader, bus, options.replay};
  Progress progress{"replay"};
  TerminalKeys terminal;
  ReplayKeys keys;
  std::string trajectory;
  const std::uint64_t sent = player.play(
      [&](double share) {
        const recorder::ReplayWish wish = keys.wish_after(terminal.typed());
        progress.show(share, keys.is_paused() ? "paused: space goes on, . is one message" : "");
        return stop_requested() ? recorder::ReplayWish::End : wish;
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
  CLI::App* command = add_command(tandem, "replay",
                                  "Send a recording's messages again, with its time as the clock. Keys: space pauses "
                                  "and goes on, . sends one message more, q ends",
                                  "tandem replay episode.mcap --rate 2 --topics odometry,scan");
  command->add_option("FILE", options->file, "Recording (.mcap)")->required();
  command->add_option("--rate", options->rate, "Recorded seconds per second, or max")->capture_default_str();
  command->add_option("--from", options->replay.from_s, "Begin this many seconds into it")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--until", options->replay.until_s, "End this many seconds into it")->check(CLI::PositiveNumber);
  command->add_option("--rename", options->renames, "Send topics under other names: RECORDED=SENT,...")->delimiter(',');
  command->add_option("--topics", options->replay.topics, "Only these, separated by commas")->delimiter(',');
  command->add_flag("--loop", options->replay.loop, "Again and again");
  command->add_flag("--lockstep", options->replay.lockstep, "Wait for localization's pose after each scan");
  command->add_option("--trajectory", options->trajectory, "With --lockstep: write the poses as lines of t x y theta");
  command->add_option("--config", options->host.config_folder, "Folder with site.toml")->capture_default_str();
  command->add_option("--domain", options->host.domain, "DDS domain, instead of the site's");
  command->callback([options] { run(*options); });
}

}  // namespace tandem::cli
