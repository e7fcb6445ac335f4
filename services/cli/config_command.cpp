#include "services/cli/config_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "services/cli/command.hpp"
#include "services/cli/config/service_configs.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

struct ConfigOptions {
  fs::path folder = "/etc/tandem";
  std::vector<std::string> services;
  bool origin = false;
  bool json = false;
};

void check(const ConfigOptions& options) {
  const auto files = check_configs(options.folder);
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  int faults = 0;
  for (const CheckedFile& checked : files) {
    faults += checked.fault.empty() ? 0 : 1;
    if (options.json) {
      all.push_back({{"file", checked.file.string()}, {"sound", checked.fault.empty()}, {"fault", checked.fault}});
    } else if (checked.fault.empty()) {
      std::printf("sound  %s\n", checked.file.c_str());
    } else {
      std::printf("WRONG  %s\n", checked.fault.c_str());
    }
  }
  if (options.json) std::puts(all.dump(2).c_str());
  if (faults > 0)
    throw WrongUse(std::to_string(faults) + " of " + std::to_string(files.size()) + " files cannot be used");
}

void show(const ConfigOptions& options) {
  nlohmann::ordered_json all;
  bool shown = false;
  for (const ConfigFile& kind : config_files()) {
    const bool is_asked =
        std::find(options.services.begin(), options.services.end(), kind.name) != options.services.end();
    const fs::path file = options.folder / (kind.name + ".toml");
    if (!is_asked && (!options.services.empty() || !fs::exists(file))) continue;
    if (!options.json) std::printf("%s# %s\n", shown ? "\n" : "", file.c_str());
    shown = true;
    for (const auto& [field, origin] : origins(kind, file)) {
      if (options.json) {
        const auto middle = field.find(" = ");
        all[kind.name][field.substr(0, middle)] = {{"value", field.substr(middle + 3)}, {"origin", origin}};
      } else if (options.origin) {
        std::printf("%-60s # %s\n", field.c_str(), origin.c_str());
      } else {
        std::printf("%s\n", field.c_str());
      }
    }
  }
  if (!shown) throw WrongUse("no configuration in " + options.folder.string() + "; name the folder with --config");
  if (options.json) std::puts(all.dump(2).c_str());
}

void add_options(CLI::App* command, ConfigOptions& options) {
  command->add_option("--config", options.folder, "Folder with site.toml and one TOML file per service")
      ->capture_default_str();
  command->add_flag("--json", options.json, "As JSON");
}

}  // namespace

void add_config_command(CLI::App& tandem) {
  const auto options = std::make_shared<ConfigOptions>();
  CLI::App* config = add_command(tandem, "config", "Check or show what the services of a host are told",
                                 "tandem config show base --origin");
  config->require_subcommand(1);

  CLI::App* checking =
      add_command(*config, "check", "Say of every file whether its service can use it, else where and why",
                  "tandem config check --config config/lab/robot");
  add_options(checking, *options);
  checking->callback([options] { check(*options); });

  std::vector<std::string> names;
  for (const ConfigFile& kind : config_files()) names.push_back(kind.name);
  CLI::App* showing = add_command(*config, "show", "Print every field with the value its service gets",
                                  "tandem config show base laser --origin");
  showing->add_option("SERVICE", options->services, "These alone: site, base, laser, ...")->check(CLI::IsMember(names));
  showing->add_flag("--origin", options->origin, "With the line it comes from, or `default`");
  add_options(showing, *options);
  showing->callback([options] { show(*options); });
}

}  // namespace tandem::cli
