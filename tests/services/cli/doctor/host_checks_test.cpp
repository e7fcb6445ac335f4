#include "services/cli/doctor/host_checks.hpp"

#include <gtest/gtest.h>

namespace tandem::cli {
namespace {

/// What is wrong must be told with what is wanted and what to do.
void expect_told(const Finding& line, Verdict verdict, const std::string& found) {
  EXPECT_EQ(line.verdict, verdict) << line.what << ": " << line.found;
  EXPECT_NE(line.found.find(found), std::string::npos) << line.found;
  EXPECT_NE(line.wanted, "") << line.what;
  EXPECT_NE(line.fix, "") << line.what;
}

TEST(HostChecks, TakeDebian12) {
  EXPECT_EQ(check_system("debian", "12").verdict, Verdict::Ok);
  expect_told(check_system("ubuntu", "22.04"), Verdict::Warning, "ubuntu 22.04");
}

TEST(HostChecks, DemandThePatchedFastDds) {
  EXPECT_EQ(check_fast_dds("2.9.1+ds-1+deb12u2", true).verdict, Verdict::Ok);
  expect_told(check_fast_dds("2.9.1+ds-1", false), Verdict::Error, "2.9.1+ds-1");
  expect_told(check_fast_dds(std::nullopt, false), Verdict::Error, "not installed");
}

TEST(HostChecks, LookAtTheInterfaceOfTheLink) {
  const LinkInterface good{"wlan0", true, true, "192.168.4.10", 1500, true, false};
  EXPECT_EQ(check_interface(good).verdict, Verdict::Ok);
  EXPECT_EQ(check_interface(good).found, "wlan0 192.168.4.10 mtu 1500");
  LinkInterface link = good;
  link.is_there = false;
  expect_told(check_interface(link), Verdict::Error, "does not exist");
  link = good;
  link.is_up = false;
  expect_told(check_interface(link), Verdict::Error, "is down");
  link = good;
  link.address.clear();
  expect_told(check_interface(link), Verdict::Error, "no address");
  link = good;
  link.mtu = 576;
  expect_told(check_interface(link), Verdict::Warning, "mtu 576");
}

TEST(HostChecks, AskForPeersWhereMulticastDoesNotWork) {
  const LinkInterface with{"wlan0", true, true, "192.168.4.10", 1500, true, {}};
  LinkInterface without = with;
  without.multicast = false;
  EXPECT_EQ(check_multicast(with, "auto", false).verdict, Verdict::Ok);
  EXPECT_EQ(check_multicast(without, "auto", true).verdict, Verdict::Ok);
  EXPECT_EQ(check_multicast(without, "server", false).verdict, Verdict::Ok);
  expect_told(check_multicast(without, "auto", false), Verdict::Warning, "no multicast");
  expect_told(check_multicast(with, "peers", false), Verdict::Error, "no peers");
}

TEST(HostChecks, WantPowerSaveOff) {
  LinkInterface link{"wlan0", true, true, "192.168.4.10", 1500, true, false};
  EXPECT_EQ(check_power_save(link).verdict, Verdict::Ok);
  link.power_save = true;
  expect_told(check_power_save(link), Verdict::Warning, "300 ms");
  link.power_save.reset();
  EXPECT_EQ(check_power_save(link).verdict, Verdict::NotApplicable);
}

TEST(HostChecks, WantAReceiveBufferOfAMegabyte) {
  EXPECT_EQ(check_receive_buffer(4'194'304).verdict, Verdict::Ok);
  expect_told(check_receive_buffer(212'992), Verdict::Warning, "208 kB");
}

TEST(HostChecks, ShowARuleThatDrops) {
  EXPECT_EQ(check_firewall(std::nullopt, true).verdict, Verdict::Ok);
  EXPECT_EQ(check_firewall(std::nullopt, false).verdict, Verdict::NotApplicable);
  expect_told(check_firewall("udp dport 7400 drop", true), Verdict::Warning, "udp dport 7400 drop");
}

TEST(HostChecks, WantRoomForRecordings) {
  Disk disk{"/var/lib/tandem/recordings", "", 50.0, 0.4, 8.0};
  EXPECT_EQ(check_disk(disk).verdict, Verdict::Ok);
  EXPECT_EQ(check_disk_speed(disk).verdict, Verdict::Ok);
  disk.free_share = 0.05;
  expect_told(check_disk(disk), Verdict::Warning, "5 %");
  disk.free_gb = 0.1;
  expect_told(check_disk(disk), Verdict::Error, "0.1 GB");
  disk.sync_ms = 2000.0;
  expect_told(check_disk_speed(disk), Verdict::Warning, "2000 ms");
  disk.trouble = "/var/lib/tandem/recordings does not exist";
  expect_told(check_disk(disk), Verdict::Error, "does not exist");
  EXPECT_EQ(check_disk_speed(disk).verdict, Verdict::NotApplicable);
}

TEST(HostChecks, WantAClockThatIsKept) {
  EXPECT_EQ(check_clock_source(true).verdict, Verdict::Ok);
  expect_told(check_clock_source(false), Verdict::Warning, "nobody");
}

TEST(HostChecks, ShowWhatSharedMemoryLeft) {
  EXPECT_EQ(check_shared_memory(0).verdict, Verdict::Ok);
  expect_told(check_shared_memory(23), Verdict::Warning, "23 files");
}

TEST(HostChecks, WantEveryDeviceThereAndOpenToUs) {
  const DeviceFact good{"base", "/dev/pioneer", true, true, true, "dialout"};
  EXPECT_EQ(check_device(good).verdict, Verdict::Ok);
  DeviceFact device = good;
  device.is_there = false;
  expect_told(check_device(device), Verdict::Error, "is not there");
  device = good;
  device.is_permitted = false;
  expect_told(check_device(device), Verdict::Error, "group dialout");
  EXPECT_EQ(check_device({"laser", "tcp://192.168.0.10:10940", false, false, false, ""}).verdict, Verdict::Ok);
}

TEST(HostChecks, NameEveryFileThatCannotBeUsed) {
  EXPECT_EQ(check_config({{"site.toml", ""}, {"relay.toml", ""}}).verdict, Verdict::Ok);
  expect_told(check_config({{"site.toml", ""}, {"relay.toml", "relay.toml:2: x: unknown key"}}), Verdict::Error,
              "relay.toml:2: x");
}

TEST(HostChecks, WantAMapThatLoads) {
  EXPECT_EQ(check_map_file("lab.yaml", "", "10 x 10 cells").verdict, Verdict::Ok);
  expect_told(check_map_file("", "lab.yaml: cannot be read", ""), Verdict::Error, "lab.yaml: cannot be read");
}

TEST(HostChecks, WantACertificateForTwoWeeksAtLeast) {
  EXPECT_EQ(check_certificate("/etc/tandem/security", 300.0).verdict, Verdict::Ok);
  expect_told(check_certificate("/etc/tandem/security", 10.0), Verdict::Warning, "10 days");
  expect_told(check_certificate("/etc/tandem/security", -1.0), Verdict::Error, "run out");
  expect_told(check_certificate("/etc/tandem/security", std::nullopt), Verdict::Error, "cannot be read");
}

}  // namespace
}  // namespace tandem::cli
