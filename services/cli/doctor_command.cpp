#include "services/cli/doctor_command.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <tuple>

#include "services/cli/command.hpp"
#include "services/cli/doctor/host_facts.hpp"
#include "services/cli/doctor/report.hpp"
#include "services/cli/doctor/team_facts.hpp"

namespace tandem::cli {
namespace {

struct DoctorOptions {
  std::filesystem::path config = "/etc/tandem";
  std::string profile = "lab";
  double listen_s = 4.0;
  bool json = false;
};

void run(const DoctorOptions& options) {
  std::ignore = stop_requested();  // from now on Ctrl-C ends it in order
  const auto site = load_config<SiteConfig>(options.config / "site.toml");
  const bool simulated = options.profile == "simulation";
  std::vector<Finding> findings = look_at_host(options.config, site, simulated);
  if (!options.json) std::fprintf(stderr, "tandem: listening to the services for %.0f s\n", options.listen_s);
  const auto of_team = listen_to_team(options.config, site, simulated, from_seconds(options.listen_s));
  findings.insert(findings.end(), of_team.begin(), of_team.end());
  std::fputs((options.json ? json_of(findings) + "\n" : text_of(findings)).c_str(), stdout);
  std::fflush(stdout);
  const Verdict worst = worst_of(findings);
  if (worst == Verdict::Error) throw Sick{2};
  if (worst == Verdict::Warning) throw Sick{1};
}

}  // namespace

void add_doctor_command(CLI::App& tandem) {
  const auto options = std::make_shared<DoctorOptions>();
  CLI::App* command =
      add_command(tandem, "doctor",
                  "Look at this host and its team: what is found, what is wanted, and how to get there. "
                  "Exit code 0: all is well; 1: warnings; 2: errors",
                  "tandem doctor --json");
  command->add_option("--config", options->config, "Folder with site.toml and one TOML file per service")
      ->capture_default_str();
  command->add_option("--profile", options->profile, "What there is: a lab's hardware, or `simulation`")
      ->check(CLI::IsMember({"lab", "simulation"}))
      ->capture_default_str();
  command->add_option("--listen-s", options->listen_s, "How long to listen to the services")
      ->check(CLI::Range(1.0, 60.0))
      ->capture_default_str();
  command->add_flag("--json", options->json, "As JSON");
  command->callback([options] { run(*options); });
}

}  // namespace tandem::cli
