#pragma once

#include <memory>
#include <string>

#include "services/bus/bus.hpp"
#include "tests/network/lab/laboratory.hpp"
#include "tests/support/link_place.hpp"
#include "tests/support/process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::test {

/// How the relay of a host of a laboratory joins the link.
struct RelayOptions {
  std::string role = "robot";
  std::string robot = "robot1";
  int host_domain = 0;
  int link_domain = 0;
  LinkPlace link{};
  std::string security_folder{};  ///< files of a secured link; empty: not secured
};

/// The relay of a host of a laboratory, as a process, and a bus for the services of that host, in the test's process.
class RelayedHost {
 public:
  RelayedHost(LabHost& host, const RelayOptions& options);

  /// Makes readers and writers of this host.
  [[nodiscard]] bus::Bus& bus() { return *bus_; }
  [[nodiscard]] const LabHost& host() const { return host_; }
  /// What the relay has used of a core so far [s].
  [[nodiscard]] double relay_cpu_s() const { return relay_->cpu_s(); }
  /// What the relay has in memory now [MB].
  [[nodiscard]] double relay_memory_MB() const { return relay_->memory_MB(); }
  [[nodiscard]] bool relay_runs() const { return relay_->is_running(); }
  /// The folder with the configuration of this host.
  [[nodiscard]] const TemporaryFolder& config() const { return config_; }
  /// Ends the relay and starts it again.
  void restart_relay();

 private:
  void start_relay();

  LabHost& host_;
  TemporaryFolder config_;
  std::unique_ptr<bus::Bus> bus_;
  std::unique_ptr<Process> relay_;
};

/// What the relay of a host says of itself.
class RelayHealth {
 public:
  explicit RelayHealth(RelayedHost& host)
      : name_(host.host().name()), reader_(host.bus().latest(topic::kServiceHealth)) {}
  [[nodiscard]] std::string reason() const {
    for (const auto& received : reader_.each()) {
      if (received.message.host() == name_ && received.message.service() == "relay") return received.message.reason();
    }
    return "";
  }
  [[nodiscard]] bool names(const std::string& text) const { return reason().find(text) != std::string::npos; }

 private:
  std::string name_;
  bus::Latest<msg::ServiceHealth, msg::ServiceHealthPubSubType> reader_;
};

}  // namespace tandem::test
