#include "services/cli/bundle_command.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <ctime>
#include <memory>
#include <string>
#include <tuple>

#include "services/cli/bundle/bundle.hpp"
#include "services/cli/command.hpp"
#include "services/cli/doctor/host_facts.hpp"
#include "services/cli/doctor/report.hpp"
#include "services/cli/doctor/team_facts.hpp"
#include "services/common/clock.hpp"
#include "services/common/file_io.hpp"
#include "services/common/version.hpp"
#include "services/recorder/core/recorder_config.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

struct BundleOptions {
  fs::path config = "/etc/tandem";
  fs::path logs;
  fs::path output = ".";
  double minutes = 5.0;
  bool simulated = false;
};

constexpr Duration kListen = std::chrono::seconds{4};

std::string name_of_now() {
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof(text), "%Y%m%dT%H%M%SZ", std::gmtime(&now));
  return text;
}

/// A folder that is gone at the end, whatever happens.
struct Folder {
  explicit Folder(fs::path folder) : path(std::move(folder)) { fs::create_directories(path); }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  fs::path path;
};

void run(const BundleOptions& options) {
  std::ignore = stop_requested();  // from now on Ctrl-C ends it in order
  const auto site = load_config<SiteConfig>(options.config / "site.toml");
  const std::string name = "tandem-" + site.host + "-" + name_of_now();
  fs::create_directories(options.output);
  const Folder work{options.output / (name + ".part.d")};
  const fs::path folder = work.path / name;
  fs::create_directories(folder);

  BundlePlan plan{options.config, options.logs, {}, from_seconds(60.0 * options.minutes)};
  if (options.minutes > 0.0) {
    try {
      plan.recordings = load_config<recorder::RecorderConfig>(options.config / "recorder.toml").folder;
    } catch (const ConfigError&) {  // the doctor names it
    }
  }
  auto left_out = fill_bundle(plan, folder);
  std::ignore = keep_output({"dpkg-query", "-W", "tandem-*", "libfastrtps2.9", "libfastcdr1", "linux-image-*"},
                            folder / "packages.txt");
  std::ignore = keep_output({"uname", "-a"}, folder / "kernel.txt");
  if (!keep_output({"journalctl", "-u", "tandem-*", "--since", "-1h", "-o", "short-iso-precise", "--no-pager"},
                   folder / "journal.txt")) {
    left_out.push_back("the journal: journalctl is not here, or you may not read it");
  }
  std::fprintf(stderr, "tandem: listening to the services for %.0f s\n", to_seconds(kListen));
  auto findings = look_at_host(options.config, site, options.simulated);
  const auto of_team = listen_to_team(options.config, site, options.simulated, kListen);
  findings.insert(findings.end(), of_team.begin(), of_team.end());
  write_file_atomically(folder / "doctor.txt", text_of(findings));

  std::string about = "tandem " + version_line() + "\n";
  for (const std::string& missing : left_out) about += "left out: " + missing + "\n";
  write_file_atomically(folder / "about.txt", about);
  const fs::path packed = options.output / (name + ".tar.gz");
  if (!keep_output({"tar", "-C", work.path.string(), "-czf", "-", name}, work.path / "packed")) {
    throw std::runtime_error("tar failed; is it installed, and is there room in " + options.output.string() + "?");
  }
  fs::rename(work.path / "packed", packed);
  for (const std::string& missing : left_out) std::fprintf(stderr, "tandem: left out: %s\n", missing.c_str());
  std::printf("%s\n", packed.c_str());
}

}  // namespace

void add_bundle_command(CLI::App& tandem) {
  const auto options = std::make_shared<BundleOptions>();
  CLI::App* command =
      add_command(tandem, "bundle",
                  "Pack what others need to help you: configuration, logs, versions, the doctor's report and "
                  "the end of the newest recording. No keys, no pairing links",
                  "tandem bundle --minutes 2");
  command->add_option("--config", options->config, "Folder with site.toml and one TOML file per service")
      ->capture_default_str();
  command->add_option("--logs", options->logs, "Folder of log files, where services were not started by systemd");
  command->add_option("--output", options->output, "Folder to put it in")->capture_default_str();
  command->add_option("--minutes", options->minutes, "Of the newest recording; 0: none")
      ->check(CLI::Range(0.0, 1440.0))
      ->capture_default_str();
  command->add_flag("--simulated", options->simulated, "The hardware is simulated: do not look for it");
  command->callback([options] { run(*options); });
}

}  // namespace tandem::cli
