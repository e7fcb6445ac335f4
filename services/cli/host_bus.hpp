#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "services/common/site_config.hpp"

namespace tandem::cli {

/// How a command is told which host's services it talks to.
struct HostOptions {
  std::filesystem::path config_folder = "/etc/tandem";  ///< --config
  std::optional<int> domain;                            ///< --domain, before the site's
};

/// The site.toml of `options`; the defaults where there is none in the default folder.
[[nodiscard]] inline SiteConfig site_of(const HostOptions& options) {
  SiteConfig site;
  const std::filesystem::path file = options.config_folder / "site.toml";
  if (options.config_folder != "/etc/tandem" || std::filesystem::exists(file)) site = load_config<SiteConfig>(file);
  if (options.domain) site.host_domain = *options.domain;
  return site;
}

}  // namespace tandem::cli
