#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "services/cli/config/service_configs.hpp"
#include "services/cli/doctor/finding.hpp"

/// What `tandem doctor` makes of the machine it runs on. Facts in, a line out; host_facts.hpp gathers the facts.
namespace tandem::cli {

[[nodiscard]] Finding check_system(const std::string& system_id, const std::string& version);

/// `is_patched`: at least the security update of Debian 12 without which one datagram can end a process.
[[nodiscard]] Finding check_fast_dds(const std::optional<std::string>& version, bool is_patched);

/// The interface of site.toml's link_address.
struct LinkInterface {
  std::string name;
  bool is_there = false;
  bool is_up = false;
  std::string address;  ///< IPv4; empty: none
  int mtu = 0;
  bool multicast = false;
  std::optional<bool> power_save;  ///< of a Wi-Fi interface, where it can be asked
};
[[nodiscard]] Finding check_interface(const LinkInterface& link);
[[nodiscard]] Finding check_multicast(const LinkInterface& link, const std::string& discovery, bool has_peers);
[[nodiscard]] Finding check_power_save(const LinkInterface& link);

/// net.core.rmem_max [bytes].
[[nodiscard]] Finding check_receive_buffer(std::int64_t rmem_max);

[[nodiscard]] Finding check_firewall(const std::optional<std::string>& dropping_rule, bool could_look);

/// Where recordings go.
struct Disk {
  std::filesystem::path folder;
  std::string trouble;  ///< why nothing can be written; empty if it can
  double free_gb = 0.0;
  double free_share = 0.0;
  double sync_ms = 0.0;  ///< the slowest of a few writes of 64 kB, each synced
};
[[nodiscard]] Finding check_disk(const Disk& disk);
[[nodiscard]] Finding check_disk_speed(const Disk& disk);

/// Whether the kernel says that its clock is kept by somebody (chrony, ntpd, timesyncd).
[[nodiscard]] Finding check_clock_source(bool is_synchronised);

/// Files that Fast DDS's shared memory left: we use none, so they are of others or of long ago.
[[nodiscard]] Finding check_shared_memory(int leftovers);

/// A device of base.toml, laser.toml or camera.toml: a file, or an address on the network.
struct DeviceFact {
  std::string service;
  std::string device;
  bool is_file = false;
  bool is_there = false;
  bool is_permitted = false;
  std::string group;  ///< of the file
};
[[nodiscard]] Finding check_device(const DeviceFact& device);

[[nodiscard]] Finding check_config(const std::vector<CheckedFile>& files);

/// `trouble`: why the map cannot be used; empty if it can, then `summary` says what it is.
[[nodiscard]] Finding check_map_file(const std::string& file, const std::string& trouble, const std::string& summary);

/// A certificate file, with the days it is still valid.
[[nodiscard]] Finding check_certificate(const std::string& file, std::optional<double> days_left);

}  // namespace tandem::cli
