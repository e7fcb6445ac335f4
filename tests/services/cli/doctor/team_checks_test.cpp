#include "services/cli/doctor/team_checks.hpp"

#include <gtest/gtest.h>

namespace tandem::cli {
namespace {

bus::ServiceSign sign(const std::string& host, const std::string& service, const std::string& state,
                      const std::string& reason = "") {
  return {host, service, "robot1", 1, "0.1.0", "abc", state, reason};
}

void expect_told(const Finding& line, Verdict verdict, const std::string& found) {
  EXPECT_EQ(line.verdict, verdict) << line.what << ": " << line.found;
  EXPECT_NE(line.found.find(found), std::string::npos) << line.found;
  EXPECT_NE(line.wanted, "") << line.what;
  EXPECT_NE(line.fix, "") << line.what;
}

TEST(TeamChecks, NameServicesThatAreSilentOrIll) {
  const auto lines = check_services("robot1", {"base", "laser", "relay", "camera"},
                                    {sign("robot1", "base", "ok"), sign("robot1", "laser", "failed", "no laser"),
                                     sign("laptop1", "relay", "ok"), sign("robot1", "camera", "degraded", "dark")});
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0].verdict, Verdict::Ok);
  expect_told(lines[1], Verdict::Error, "failed: no laser");
  expect_told(lines[2], Verdict::Error, "silent");  // the other host's relay is not ours
  expect_told(lines[3], Verdict::Warning, "degraded: dark");
}

TEST(TeamChecks, WantOneContract) {
  EXPECT_EQ(check_versions({sign("robot1", "base", "ok")}, "abc", "0.1.0").verdict, Verdict::Ok);
  EXPECT_EQ(check_versions({}, "abc", "0.1.0").verdict, Verdict::NotApplicable);
  bus::ServiceSign old = sign("laptop1", "planner", "ok");
  old.contract_hash = "def";
  old.version = "0.0.9";
  expect_told(check_versions({sign("robot1", "base", "ok"), old}, "abc", "0.1.0"), Verdict::Error,
              "laptop1/planner 0.0.9");
}

TEST(TeamChecks, TellWhatIsWrongWithTheLink) {
  const LinkFact good{"laptop1", true, false, 0.02, 0.01, 0.001};
  EXPECT_EQ(check_link(good).verdict, Verdict::Ok);
  EXPECT_EQ(check_link(good).found, "laptop1: 20 ms there and back, 1 % lost");
  expect_told(check_link(std::nullopt), Verdict::Error, "relay is silent");
  expect_told(check_link(LinkFact{}), Verdict::Error, "no other host");
  LinkFact link = good;
  link.one_way = true;
  expect_told(check_link(link), Verdict::Error, "one way");
  link = good;
  link.up = false;
  expect_told(check_link(link), Verdict::Error, "no longer heard");
  link = good;
  link.loss = 0.3;
  expect_told(check_link(link), Verdict::Warning, "30 % lost");
}

TEST(TeamChecks, WantClocksWithinFiftyMilliseconds) {
  LinkFact link{"laptop1", true, false, 0.02, 0.01, -0.049};
  EXPECT_EQ(check_clock_offset(link).verdict, Verdict::Ok);
  link.clock_offset_s = 0.1;
  expect_told(check_clock_offset(link), Verdict::Warning, "100 ms");
  link.clock_offset_s = -0.3;
  expect_told(check_clock_offset(link), Verdict::Error, "300 ms");
  EXPECT_EQ(check_clock_offset(std::nullopt).verdict, Verdict::NotApplicable);
}

TEST(TeamChecks, WantOneMap) {
  EXPECT_EQ(check_maps({"0123456789abcdef"}).verdict, Verdict::Ok);
  expect_told(check_maps({}), Verdict::Error, "no map");
  expect_told(check_maps({"0123456789abcdef", "fedcba9876543210"}), Verdict::Error, "0123456789ab, fedcba987654");
}

TEST(TeamChecks, LookAtTheBase) {
  const BaseFact good{true, "p2at", 500, 12.6, false, ""};
  for (const Finding& line : check_base(good, {})) EXPECT_EQ(line.verdict, Verdict::Ok) << line.what;
  expect_told(check_base(std::nullopt, {}).at(0), Verdict::Error, "silent");
  expect_told(check_base(BaseFact{}, {}).at(0), Verdict::Error, "does not answer");
  BaseFact base = good;
  base.watchdog_ms = 2000;  // the factory's
  expect_told(check_base(base, {}).at(1), Verdict::Warning, "2000 ms");
  base.watchdog_ms = 0;
  expect_told(check_base(base, {}).at(1), Verdict::Warning, "not known");
  base = good;
  base.battery_v = 11.7;
  expect_told(check_base(base, {}).at(2), Verdict::Warning, "11.7 V");
  base.battery_v = 11.2;
  expect_told(check_base(base, {}).at(2), Verdict::Error, "11.2 V");
  base = good;
  base.estop_pressed = true;
  expect_told(check_base(base, {}).at(3), Verdict::Warning, "pressed");
}

TEST(TeamChecks, WantScansAtARateAndWithBeams) {
  EXPECT_EQ(check_laser(ScanFact{10.0, 0.95}).verdict, Verdict::Ok);
  expect_told(check_laser(std::nullopt), Verdict::Error, "no scan");
  expect_told(check_laser(ScanFact{3.0, 0.95}), Verdict::Warning, "3.0 scans");
  expect_told(check_laser(ScanFact{10.0, 0.5}), Verdict::Warning, "50 %");
}

}  // namespace
}  // namespace tandem::cli
