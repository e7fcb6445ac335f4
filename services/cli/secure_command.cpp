#include "services/cli/secure_command.hpp"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>

#include "services/cli/command.hpp"
#include "services/common/clock.hpp"
#include "services/relay/link_security.hpp"
#include "services/security/host_files.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;
using security::Validity;
using std::chrono::days;

constexpr days kValidBefore{1};  // a clock that is a little behind does no harm

Validity validity_of(int for_days) {
  const Time now = std::chrono::floor<std::chrono::seconds>(wall_time());
  return {now - kValidBefore, now + days{for_days}};
}

struct InitOptions {
  std::string folder = "tandem-authority";
  int days = 3650;
};

void run_init(const InitOptions& options) {
  security::make_authority(options.folder, validity_of(options.days));
  std::printf(
      "Authority of the link made: %s, for %d days. Keep authority.key where no guest comes: who has it can be a "
      "robot.\n"
      "Next, for each host: tandem secure add HOST --role robot|laptop --robot ROBOT --folder %s\n",
      options.folder.c_str(), options.days, options.folder.c_str());
}

struct AddOptions {
  std::string host;
  std::string role;
  std::string robot = "robot1";
  std::string folder = "tandem-authority";
  int days = 730;
};

void run_add(const AddOptions& options) {
  // They become names of files, and stand in XML and in a certificate.
  const std::regex plain{"[A-Za-z0-9._-]{1,64}"};
  for (const auto& name : {options.host, options.robot}) {
    if (!std::regex_match(name, plain) || name.front() == '.') {
      throw WrongUse("\"" + name + "\": letters, digits, - _ and . only, as in site.toml");
    }
  }
  const HostRole role = options.role == "robot" ? HostRole::Robot : HostRole::Laptop;
  const LinkTopics topics = link_topics(role);
  const fs::path made =
      security::make_host_files(options.folder, options.host,
                                {"", options.robot, topics.publishes, topics.subscribes, validity_of(options.days)});
  std::printf(
      "Made for %s, a %s of the team of %s, for %d days: %s\n"
      "Copy what is in it to /etc/tandem/security on %s, owned by who runs Tandem there, and set in its site.toml:\n"
      "    secure_link = true\n"
      "Then, on %s: tandem secure check\n",
      options.host.c_str(), options.role.c_str(), options.robot.c_str(), options.days, made.c_str(),
      options.host.c_str(), options.host.c_str());
}

struct CheckOptions {
  std::string config = "/etc/tandem";
  bool json = false;
};

/// What is wrong with the whole, apart from the files.
std::vector<std::string> problems_of_site(const SiteConfig& site) {
  if (site.role == "both") return {"site.toml: role = \"both\": everything runs on this host, there is no link"};
  if (!site.secure_link) return {"site.toml: secure_link = false: the link is not secured"};
  if (site.discovery == "server") return {"site.toml: secure_link does not go with discovery = \"server\""};
  return {};
}

void run_check(const CheckOptions& options) {
  const auto site = load_config<SiteConfig>(fs::path{options.config} / "site.toml");
  const Time now = wall_time();
  auto problems = security::problems_of(security_files_in(site.security_folder), expected_of(site), now);
  const bool files_hold = problems.empty();
  for (auto& problem : problems_of_site(site)) problems.push_back(std::move(problem));
  const int left = files_hold ? days_left(site, now) : 0;
  if (options.json) {
    nlohmann::ordered_json report{{"usable", problems.empty()}, {"problems", problems}};
    if (files_hold) report["days_left"] = left;
    std::puts(report.dump(2).c_str());
  } else {
    for (const auto& problem : problems) std::printf("%s\n", problem.c_str());
    if (files_hold) std::printf("%s: usable for %d more days\n", site.security_folder.c_str(), left);
  }
  if (!problems.empty()) throw Failed{};
}

void add_init(CLI::App& secure) {
  const auto options = std::make_shared<InitOptions>();
  CLI::App* init = add_command(secure, "init", "Make the authority that signs for all hosts of the lab, once",
                               "tandem secure init --folder ~/tandem-authority");
  init->add_option("--folder", options->folder, "Where to keep it; default: tandem-authority");
  init->add_option("--days", options->days, "How long it holds; default: 3650")->check(CLI::Range(1, 36500));
  init->callback([options] { run_init(*options); });
}

void add_add(CLI::App& secure) {
  const auto options = std::make_shared<AddOptions>();
  CLI::App* add = add_command(secure, "add", "Make the certificate, key and permissions of a host, or make them again",
                              "tandem secure add laptop1 --role laptop --robot robot1");
  add->add_option("HOST", options->host, "Its name: host in its site.toml")->required();
  add->add_option("--role", options->role, "Its role: what it may say and hear")
      ->required()
      ->check(CLI::IsMember({"robot", "laptop"}));
  add->add_option("--robot", options->robot, "Its team: robot in its site.toml; default: robot1");
  add->add_option("--folder", options->folder, "Where the authority is; default: tandem-authority");
  add->add_option("--days", options->days, "How long they hold; default: 730")->check(CLI::Range(1, 36500));
  add->callback([options] { run_add(*options); });
}

void add_check(CLI::App& secure) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* check =
      add_command(secure, "check", "Say what is wrong with the security files of this host, and what to do",
                  "tandem secure check --config /etc/tandem");
  check->add_option("--config", options->config, "Folder of site.toml; default: /etc/tandem");
  check->add_flag("--json", options->json, "Report as JSON");
  check->callback([options] { run_check(*options); });
}

}  // namespace

void add_secure_command(CLI::App& tandem) {
  CLI::App* secure =
      add_command(tandem, "secure", "Let only hosts with a certificate take part in the link", "tandem secure init");
  secure->require_subcommand(1);
  add_init(*secure);
  add_add(*secure);
  add_check(*secure);
}

}  // namespace tandem::cli
