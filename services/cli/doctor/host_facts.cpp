#include "services/cli/doctor/host_facts.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <grp.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/timex.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <sstream>

#include "robot/camera/core/camera_config.hpp"
#include "robot/laser/core/laser_config.hpp"
#include "robot/pioneer/base_config.hpp"
#include "services/common/clock.hpp"
#include "services/common/file_io.hpp"
#include "services/common/format.hpp"
#include "services/mapping/core/map_file.hpp"
#include "services/mapping/core/map_server_config.hpp"
#include "services/recorder/core/recorder_config.hpp"
#include "services/relay/link_security.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

/// What a command printed, without the last line end; nothing if it failed or is not there.
std::optional<std::string> output_of(const std::string& command) {
  FILE* pipe = ::popen((command + " 2>/dev/null").c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  std::string text;
  std::array<char, 4096> buffer{};
  for (std::size_t size = 0; (size = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    text.append(buffer.data(), size);
  if (::pclose(pipe) != 0) return std::nullopt;
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

std::string text_of(const fs::path& file) {
  try {
    return read_file(file);
  } catch (const FileError&) {
    return "";
  }
}

std::int64_t number_in(const fs::path& file) {
  const std::string text = text_of(file);
  std::int64_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// VALUE of KEY=VALUE or KEY="VALUE" in a file like /etc/os-release.
std::string value_of(const std::string& text, const std::string& key) {
  std::istringstream lines{text};
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(key + "=")) continue;
    std::string value = line.substr(key.size() + 1);
    std::erase(value, '"');
    return value;
  }
  return "";
}

Finding look_at_fast_dds() {
  const auto version = output_of("dpkg-query -W -f='${Version}' libfastrtps2.9");
  const bool is_patched = version && output_of("dpkg --compare-versions '" + *version + "' ge 2.9.1+ds-1+deb12u2");
  return check_fast_dds(version, is_patched);
}

LinkInterface interface_of(const SiteConfig& site) {
  LinkInterface link;
  link.name = site.link_address;
  ifaddrs* all = nullptr;
  if (::getifaddrs(&all) != 0) return link;
  for (const ifaddrs* entry = all; entry != nullptr; entry = entry->ifa_next) {
    if (entry->ifa_addr == nullptr || entry->ifa_addr->sa_family != AF_INET) continue;
    std::array<char, INET_ADDRSTRLEN> address{};
    ::inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(entry->ifa_addr)->sin_addr, address.data(),
                address.size());
    if (site.link_address != entry->ifa_name && site.link_address != address.data()) continue;
    link.name = entry->ifa_name;
    link.address = address.data();
    link.is_up = (entry->ifa_flags & IFF_UP) != 0;
    link.multicast = (entry->ifa_flags & IFF_MULTICAST) != 0;
    break;
  }
  ::freeifaddrs(all);
  const fs::path about = fs::path{"/sys/class/net"} / link.name;
  link.is_there = fs::exists(about);
  if (link.is_there && link.address.empty()) link.is_up = text_of(about / "operstate").starts_with("up");
  link.mtu = static_cast<int>(number_in(about / "mtu"));
  if (fs::exists(about / "wireless")) {
    if (const auto said = output_of("iw dev " + link.name + " get power_save")) link.power_save = said->ends_with("on");
  }
  return link;
}

Finding look_at_firewall() {
  if (::geteuid() != 0) return check_firewall(std::nullopt, false);
  const auto rules = output_of("nft list ruleset");
  if (!rules) return check_firewall(std::nullopt, false);
  std::istringstream lines{*rules};
  for (std::string line; std::getline(lines, line);) {
    const bool drops = line.find("policy drop") != std::string::npos || line.find(" drop") != std::string::npos ||
                       line.find(" reject") != std::string::npos;
    if (drops) return check_firewall(line.substr(line.find_first_not_of(" \t")), true);
  }
  return check_firewall(std::nullopt, true);
}

/// The slowest of a few writes, each made safe [ms]; a negative one where nothing can be written.
double slowest_sync_ms(const fs::path& folder) {
  const std::string name = (folder / (".doctor-" + std::to_string(::getpid()))).string();
  const int file = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (file < 0) return -1.0;
  const std::vector<char> data(65'536, 'x');
  const SteadyClock clock;
  double slowest_s = 0.0;
  for (int i = 0; i < 5 && slowest_s >= 0.0; ++i) {
    const Time began = clock.now();
    const bool written =
        ::write(file, data.data(), data.size()) == static_cast<ssize_t>(data.size()) && ::fdatasync(file) == 0;
    slowest_s = written ? std::max(slowest_s, to_seconds(clock.now() - began)) : -1.0;
  }
  ::close(file);
  ::unlink(name.c_str());
  return 1000.0 * slowest_s;
}

Disk look_at_disk(const fs::path& config_folder) {
  Disk disk;
  try {
    disk.folder = load_config<recorder::RecorderConfig>(config_folder / "recorder.toml").folder;
  } catch (const ConfigError& error) {
    disk.trouble = error.what();
    return disk;
  }
  struct statvfs about {};
  if (::statvfs(disk.folder.c_str(), &about) != 0) {
    disk.trouble = disk.folder.string() + " does not exist";
    return disk;
  }
  disk.free_gb = static_cast<double>(about.f_bavail) * static_cast<double>(about.f_frsize) * 1e-9;
  disk.free_share = static_cast<double>(about.f_bavail) / static_cast<double>(std::max<fsblkcnt_t>(about.f_blocks, 1));
  disk.sync_ms = slowest_sync_ms(disk.folder);
  if (disk.sync_ms < 0.0) disk.trouble = disk.folder.string() + " cannot be written to";
  return disk;
}

int shared_memory_leftovers() {
  std::error_code ignored;
  int count = 0;
  for (const auto& entry : fs::directory_iterator{"/dev/shm", ignored}) {
    const std::string name = entry.path().filename();
    count += name.starts_with("fastrtps_") || name.starts_with("fast_datasharing_") ? 1 : 0;
  }
  return count;
}

DeviceFact device_of(const std::string& service, const std::string& device) {
  DeviceFact fact{service, device, device.starts_with("/"), false, false, ""};
  struct stat about {};
  fact.is_there = ::stat(device.c_str(), &about) == 0;
  fact.is_permitted = ::access(device.c_str(), R_OK | W_OK) == 0;
  if (fact.is_there) {
    const group* owner = ::getgrgid(about.st_gid);
    fact.group = owner != nullptr ? owner->gr_name : std::to_string(about.st_gid);
  }
  return fact;
}

template <typename Config>
void look_at_device(std::vector<Finding>& lines, const fs::path& folder, const std::string& service,
                    std::string Config::*device) {
  const fs::path file = folder / (service + ".toml");
  if (!fs::exists(file)) return;
  try {
    lines.push_back(check_device(device_of(service, load_config<Config>(file).*device)));
  } catch (const ConfigError&) {  // named among the configurations already
  }
}

Finding look_at_map(const fs::path& folder) {
  try {
    const auto config = load_config<MapServerConfig>(folder / "map-server.toml");
    const fs::path file = folder / config.map;
    const OccupancyGrid grid = load_map(file);
    return check_map_file(file.string(), "",
                          formatted("%d x %d cells of %.3f m, sha256 %.12s", grid.width(), grid.height(),
                                    grid.resolution_m(), sha256_of_cells(grid).c_str()));
  } catch (const std::exception& error) {
    return check_map_file("", error.what(), "");
  }
}

Finding look_at_certificate(const SiteConfig& site) {
  if (!site.secure_link) return not_applicable("certificate", "secure_link = false: the link is not secured");
  try {
    return check_certificate(site.security_folder, days_left(site, wall_time()));
  } catch (const std::exception&) {
    return check_certificate(site.security_folder, std::nullopt);
  }
}

bool clock_is_kept() {
  timex about{};
  return ::adjtimex(&about) >= 0 && (about.status & STA_UNSYNC) == 0;
}

}  // namespace

std::vector<Finding> look_at_host(const fs::path& folder, const SiteConfig& site, bool simulated) {
  std::vector<Finding> lines;
  const std::string release = text_of("/etc/os-release");
  lines.push_back(check_system(value_of(release, "ID"), value_of(release, "VERSION_ID")));
  lines.push_back(look_at_fast_dds());
  lines.push_back(check_config(check_configs(folder)));
  lines.push_back(look_at_map(folder));
  const Disk disk = look_at_disk(folder);
  lines.push_back(check_disk(disk));
  lines.push_back(check_disk_speed(disk));
  lines.push_back(check_shared_memory(shared_memory_leftovers()));
  lines.push_back(check_receive_buffer(number_in("/proc/sys/net/core/rmem_max")));
  lines.push_back(look_at_firewall());
  lines.push_back(look_at_certificate(site));
  if (simulated) {
    for (const char* what : {"interface of the link", "finding each other", "Wi-Fi power save", "clock", "devices"}) {
      lines.push_back(not_applicable(what, "simulated: both hosts are this machine, the hardware is a program"));
    }
    return lines;
  }
  const LinkInterface link = interface_of(site);
  lines.push_back(check_interface(link));
  lines.push_back(check_multicast(link, site.discovery, !site.peers.empty()));
  lines.push_back(check_power_save(link));
  lines.push_back(check_clock_source(clock_is_kept()));
  if (site.role != "laptop") {
    look_at_device(lines, folder, "base", &BaseConfig::device);
    look_at_device(lines, folder, "laser", &LaserConfig::device);
    look_at_device(lines, folder, "camera", &CameraConfig::source);
  }
  return lines;
}

}  // namespace tandem::cli
