#include "services/cli/record_command.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "services/cli/command.hpp"
#include "services/cli/host_bus.hpp"
#include "services/recorder/recorder_service.hpp"

namespace tandem::cli {
namespace {

struct RecordOptions {
  std::filesystem::path output;
  recorder::RecorderConfig recorder;
  HostOptions host;
  double seconds = 0.0;
};

void run(const RecordOptions& options) {
  const SiteConfig site = site_of(options.host);
  bus::Bus bus{bus::host_domain(site, "record")};
  recorder::RecorderConfig config = options.recorder;
  config.folder = ".";
  const Time start = bus.clock().now();
  const std::filesystem::path file = options.output.empty() ? recorder::recording_path(config, start) : options.output;
  recorder::RecorderService service{config, site, file, recorder::config_attachments(options.host.config_folder, start),
                                    bus};
  std::fprintf(stderr, "recording %s, end with Ctrl-C\n", file.c_str());
  const auto is_over = [&] {
    return options.seconds > 0.0 && bus.clock().now() - start >= from_seconds(options.seconds);
  };
  while (!stop_requested() && !is_over() && !service.is_stopped()) service.step();
  const bool failed = service.is_stopped();
  std::fprintf(stderr, "%s\n", service.finish().c_str());
  if (failed) throw Failed{};
}

}  // namespace

void add_record_command(CLI::App& tandem) {
  const auto options = std::make_shared<RecordOptions>();
  CLI::App* command = add_command(tandem, "record", "Record every topic of this host until Ctrl-C",
                                  "tandem record -o episode.mcap --seconds 60");
  command->add_option("-o,--output", options->output, "Recording to write; default: date and time, here");
  command->add_option("--seconds", options->seconds, "End by itself after so long")->check(CLI::NonNegativeNumber);
  recorder::RecorderConfig& recorder = options->recorder;
  command->add_option("--topics", recorder.topics, "Only these, as patterns (*, ?) separated by commas")
      ->delimiter(',');
  command->add_option("--without", recorder.without_topics, "Not these, as patterns")->delimiter(',');
  command->add_option("--rotate-mb", recorder.rotate_mb, "Go on in a new file after so much; 0: never")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--rotate-s", recorder.rotate_s, "Go on in a new file after so long; 0: never")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      ->add_option("--pre-roll", recorder.pre_roll_s,
                   "Wait for an event (STOP, find, message, pose hint) and record this many seconds before it, too")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--config", options->host.config_folder, "Folder with site.toml")->capture_default_str();
  command->add_option("--domain", options->host.domain, "DDS domain, instead of the site's");
  command->callback([options] { run(*options); });
}

}  // namespace tandem::cli
