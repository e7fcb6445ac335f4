#include "services/cli/status_command.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "services/cli/command.hpp"
#include "services/cli/host_bus.hpp"
#include "services/cli/live_view.hpp"
#include "services/cli/status/status_watch.hpp"

namespace tandem::cli {
namespace {

struct StatusOptions {
  HostOptions host;
  bool watch = false;
  bool json = false;
  double seconds = 2.0;
};

void run(const StatusOptions& options, bool seconds_given) {
  const SiteConfig site = site_of(options.host);
  bus::Bus bus{bus::host_domain(site, "status")};
  const StatusWatch watch{bus, site};
  show({.title = "tandem status of " + site.host,
        .step = [] {},
        .lines = [&] { return lines_of(watch.status()); },
        .json = [&] { return json_of(watch.status()); }},
       bus,
       {.watch = options.watch,
        .json = options.json,
        .seconds = options.seconds,
        .endless = options.watch && !seconds_given});
  if (!options.watch && is_troubled(watch.status())) throw Failed{};
}

}  // namespace

void add_status_command(CLI::App& tandem) {
  const auto options = std::make_shared<StatusOptions>();
  CLI::App* command = add_command(tandem, "status",
                                  "Show how the team is: link, robot, person, session, plan, and every service. Exit "
                                  "code 1 when something is not well",
                                  "tandem status --watch");
  command->add_flag("--watch", options->watch, "Again and again: live on a terminal, until q or Ctrl-C");
  const auto* seconds =
      command->add_option("--seconds", options->seconds, "How long to listen (default: 2)")->check(CLI::PositiveNumber);
  command->add_flag("--json", options->json, "As JSON; with --watch, a line each time");
  command->add_option("--config", options->host.config_folder, "Folder with site.toml")->capture_default_str();
  command->add_option("--domain", options->host.domain, "DDS domain, instead of the site's");
  command->callback([options, seconds] { run(*options, seconds->count() > 0); });
}

}  // namespace tandem::cli
