#include "tests/network/relayed_host.hpp"

#include "services/common/config.hpp"
#include "services/common/file_io.hpp"

namespace tandem::test {

RelayedHost::RelayedHost(LabHost& host, const RelayOptions& options) : host_(host) {
  SiteConfig site;
  site.host = host.name();
  site.role = options.role;
  site.robot = options.robot;
  site.host_domain = options.host_domain;
  site.link_domain = options.link_domain;
  join(site, options.link);
  site.secure_link = !options.security_folder.empty();
  if (site.secure_link) site.security_folder = options.security_folder;
  write_file_atomically(config_ / "site.toml", write_config(site));
  write_file_atomically(config_ / "relay.toml", "");
  // Threads of the bus are made in the host's network and stay there.
  bus_ = host.run([&] { return std::make_unique<bus::Bus>(bus::host_domain(site, "test")); });
  start_relay();
}

void RelayedHost::start_relay() {
  const std::string program = std::string{TANDEM_BINARY_DIR} + "/bin/tandem-relay";
  relay_ = host_.run([&] {
    return std::make_unique<Process>(std::vector<std::string>{program, "--config", config_.path().string()});
  });
}

void RelayedHost::restart_relay() {
  relay_.reset();
  start_relay();
}

}  // namespace tandem::test
