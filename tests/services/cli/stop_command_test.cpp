#include <gtest/gtest.h>

#include <cstdio>
#include <future>
#include <string>

#include "services/bus/events.hpp"
#include "tests/support/domain_lease.hpp"

namespace tandem {
namespace {

constexpr Duration kLong = std::chrono::seconds{15};

struct Ended {
  int code = -1;
  std::string text;
};

/// Runs `tandem WORDS` on the host domain, and gives what it printed.
Ended run(const std::string& words, int domain) {
  const std::string command =
      TANDEM_BINARY_DIR "/bin/tandem " + words + " --domain " + std::to_string(domain) + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  Ended ended;
  for (int c = 0; (c = std::fgetc(pipe)) != EOF;) ended.text += static_cast<char>(c);
  ended.code = WEXITSTATUS(pclose(pipe));
  return ended;
}

bus::DomainOptions base_of(int domain) {
  SiteConfig site;
  site.host_domain = domain;
  return bus::host_domain(site, "base");
}

TEST(StopCommand, StopsTheSitesRobotAndSaysThatItHeard) {
  const test::DomainLease domains{1};
  bus::Bus bus{base_of(domains[0])};
  bus::EventReceiver stops{bus, topic::kStopRequest, "base"};
  auto command = std::async(std::launch::async, run, "stop", domains[0]);
  std::vector<msg::StopRequest> heard;
  ASSERT_TRUE(bus::wait_until(bus, kLong, [&] { return !(heard = stops.take()).empty(); }));
  EXPECT_EQ(heard[0].robot(), "robot1");
  EXPECT_TRUE(heard[0].latched());
  stops.applied(heard[0].id());
  const Ended ended = command.get();
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.text, "STOP delivered\n");
}

TEST(StopCommand, SaysWhyTheBaseDoesNotResume) {
  const test::DomainLease domains{1};
  bus::Bus bus{base_of(domains[0])};
  bus::EventReceiver resumes{bus, topic::kResumeRequest, "base"};
  auto command = std::async(std::launch::async, run, "resume --clear", domains[0]);
  std::vector<msg::ResumeRequest> heard;
  ASSERT_TRUE(bus::wait_until(bus, kLong, [&] { return !(heard = resumes.take()).empty(); }));
  EXPECT_EQ(heard[0].held_ms(), 1000u);
  resumes.refused(heard[0].id(), "emergency stop");
  const Ended ended = command.get();
  EXPECT_EQ(ended.code, 1);
  EXPECT_NE(ended.text.find("resume refused by base: emergency stop"), std::string::npos) << ended.text;
}

TEST(StopCommand, DoesNotResumeUnlessSomebodyHasLooked) {
  const test::DomainLease domains{1};
  const Ended ended = run("resume", domains[0]);
  EXPECT_EQ(ended.code, 2);
  EXPECT_NE(ended.text.find("--clear"), std::string::npos);
}

TEST(StopCommand, SaysThatNobodyHeardIt) {
  const test::DomainLease domains{1};
  const Ended ended = run("stop", domains[0]);
  EXPECT_EQ(ended.code, 1);
  EXPECT_NE(ended.text.find("NOT delivered"), std::string::npos) << ended.text;
}

}  // namespace
}  // namespace tandem
