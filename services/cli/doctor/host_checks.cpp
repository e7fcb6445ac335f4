#include "services/cli/doctor/host_checks.hpp"

#include "services/common/format.hpp"

namespace tandem::cli {
Finding check_system(const std::string& system_id, const std::string& version) {
  const std::string found = system_id + " " + version;
  if (system_id == "debian" && version == "12") return fine("system", found);
  return warning("system", found, "debian 12", "Tandem is made and tested on Debian 12; elsewhere run its tests first");
}

Finding check_fast_dds(const std::optional<std::string>& version, bool is_patched) {
  const char* what = "Fast DDS";
  const char* wanted = "2.9.1+ds-1+deb12u2 or newer";
  if (!version) return fault(what, "libfastrtps2.9 is not installed", wanted, "apt-get install libfastrtps2.9");
  if (is_patched) return fine(what, *version);
  return fault(what, *version, wanted, "apt-get update && apt-get install libfastrtps2.9 (security updates)");
}

Finding check_interface(const LinkInterface& link) {
  const std::string what = "interface of the link";
  const std::string wanted = "an interface that is up, with an IPv4 address and an MTU of at least 1280";
  if (!link.is_there) {
    return fault(what, link.name + " does not exist", wanted,
                 "set link_address in site.toml to one of `ip -brief address`");
  }
  if (!link.is_up || link.address.empty()) {
    return fault(what, link.name + (link.is_up ? " has no address" : " is down"), wanted,
                 "join the Wi-Fi: `nmcli device status`");
  }
  const std::string found = link.name + " " + link.address + " mtu " + std::to_string(link.mtu);
  // WireGuard's 1420 is enough for our fragments; below 1280 they would be cut again.
  if (link.mtu < 1280) return warning(what, found, "mtu of at least 1280", "ip link set " + link.name + " mtu 1500");
  return fine(what, found);
}

Finding check_multicast(const LinkInterface& link, const std::string& discovery, bool has_peers) {
  const std::string what = "finding each other";
  const std::string how = "discovery = " + discovery;
  if (discovery == "server") return fine(what, how);
  if (link.multicast && discovery != "peers") return fine(what, how + ", " + link.name + " takes multicast");
  if (has_peers) return fine(what, how + ", peers are named");
  const Verdict verdict = discovery == "auto" || discovery == "multicast" ? Verdict::Warning : Verdict::Error;
  return {what, verdict, how + ", " + link.name + (link.multicast ? "" : " takes no multicast") + ", no peers",
          "multicast, or the other host's address", "name the other host in peers of site.toml"};
}

Finding check_power_save(const LinkInterface& link) {
  const std::string what = "Wi-Fi power save";
  if (!link.power_save) return not_applicable(what, link.name + " is no Wi-Fi, or `iw` is not installed");
  if (!*link.power_save) return fine(what, "off");
  return warning(what, "on: packets wait for up to 300 ms", "off", "iw dev " + link.name + " set power_save off");
}

Finding check_receive_buffer(std::int64_t rmem_max) {
  const std::string found = std::to_string(rmem_max / 1024) + " kB";
  if (rmem_max >= 1'000'000) return fine("receive buffer", found);
  return warning("receive buffer", found, "net.core.rmem_max of at least 1 MB",
                 "sysctl -p /usr/lib/sysctl.d/60-tandem.conf");
}

Finding check_firewall(const std::optional<std::string>& dropping_rule, bool could_look) {
  if (!could_look) return not_applicable("firewall", "only root can look, with nft installed");
  if (!dropping_rule) return fine("firewall", "drops nothing");
  return warning("firewall", *dropping_rule, "UDP of the other host, and the gateway's TCP port, come in",
                 "let them in: docs/network.md says which ports");
}

Finding check_disk(const Disk& disk) {
  const std::string what = "disk of recordings";
  const std::string where = disk.folder.string();
  if (!disk.trouble.empty()) return fault(what, disk.trouble, "a folder to write into", "set folder in recorder.toml");
  const std::string found =
      where + " " + formatted("%.1f GB free", disk.free_gb) + formatted(" (%.0f %%)", 100.0 * disk.free_share);
  if (disk.free_gb < 0.2) return fault(what, found, "at least 2 GB", "move recordings away; recording would stop soon");
  if (disk.free_gb < 2.0 || disk.free_share < 0.1)
    return warning(what, found, "at least 2 GB and 10 %", "move recordings away");
  return fine(what, found);
}

Finding check_disk_speed(const Disk& disk) {
  const std::string what = "disk's patience";
  if (!disk.trouble.empty()) return not_applicable(what, "nothing can be written");
  const std::string found = formatted("%.0f ms for the slowest of a few synced writes", disk.sync_ms);
  if (disk.sync_ms <= 500.0) return fine(what, found);
  return warning(what, found, "500 ms at most: so often a recording is made safe", "record onto another disk");
}

Finding check_clock_source(bool is_synchronised) {
  if (is_synchronised) return fine("clock", "kept in time");
  return warning("clock", "nobody keeps it in time", "chrony, the laptop following the robot",
                 "apt-get install chrony; docs/deployment.md has its settings");
}

Finding check_shared_memory(int leftovers) {
  if (leftovers == 0) return fine("/dev/shm", "nothing of Fast DDS's lies there");
  return warning("/dev/shm", std::to_string(leftovers) + " files of Fast DDS's shared memory",
                 "none: Tandem uses none, another program does or died",
                 "rm /dev/shm/fastrtps_* /dev/shm/fast_datasharing_*");
}

Finding check_device(const DeviceFact& device) {
  const std::string what = "device of the " + device.service;
  if (!device.is_file) return fine(what, device.device + " on the network");
  if (!device.is_there) {
    return fault(
        what, device.device + " is not there", "the device, plugged in and switched on",
        "look at `ls -l /dev/serial/by-id /dev/video*`, then set it in " + device.service + ".toml or in a udev rule");
  }
  if (!device.is_permitted) {
    return fault(what, device.device + " belongs to group " + device.group + ", which you are not in", "read and write",
                 "adduser tandem " + device.group + " (the packages do it for their services)");
  }
  return fine(what, device.device);
}

Finding check_config(const std::vector<CheckedFile>& files) {
  std::string faults;
  for (const CheckedFile& checked : files) {
    if (!checked.fault.empty()) faults += (faults.empty() ? "" : "; ") + checked.fault;
  }
  if (faults.empty()) return fine("configuration", std::to_string(files.size()) + " files are sound");
  return fault("configuration", faults, "files that every service can use",
               "correct them; `tandem config check` looks again");
}

Finding check_map_file(const std::string& file, const std::string& trouble, const std::string& summary) {
  if (trouble.empty()) return fine("map", file + ": " + summary);
  return fault("map", trouble, "a map_server YAML file with its picture",
               "set map in map-server.toml; `tandem map build` makes one from a recording");
}

Finding check_certificate(const std::string& file, std::optional<double> days_left) {
  const std::string what = "certificate";
  const char* again = "`tandem secure host` makes a new one";
  if (!days_left) return fault(what, file + " cannot be read", "a certificate of the lab's authority", again);
  const std::string found = file + formatted(": %.0f days left", *days_left);
  if (*days_left <= 0.0) return fault(what, file + " has run out", "a certificate that is valid", again);
  if (*days_left < 14.0) return warning(what, found, "at least 14 days", again);
  return fine(what, found);
}

}  // namespace tandem::cli
