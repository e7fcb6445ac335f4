#include "services/security/documents.hpp"

#include <gtest/gtest.h>

namespace tandem::security {
namespace {

const Time kNow = from_stamp_ns(1'800'000'000'000'000'000);  // 2027-01-15 08:00:00 UTC

TEST(Governance, LetsNobodyInWithoutCertificateAndLeavesNothingOpen) {
  const std::string xml = governance_xml();

  EXPECT_EQ(element_of(xml, "allow_unauthenticated_participants"), "false");
  EXPECT_EQ(element_of(xml, "enable_join_access_control"), "true");
  EXPECT_EQ(element_of(xml, "discovery_protection_kind"), "ENCRYPT");
  EXPECT_EQ(element_of(xml, "liveliness_protection_kind"), "ENCRYPT");
  EXPECT_EQ(element_of(xml, "rtps_protection_kind"), "NONE");
  EXPECT_EQ(texts_of(xml, "topic_expression"), std::vector<std::string>{"*"});
  EXPECT_EQ(element_of(xml, "enable_read_access_control"), "true");
  EXPECT_EQ(element_of(xml, "enable_write_access_control"), "true");
  EXPECT_EQ(element_of(xml, "metadata_protection_kind"), "ENCRYPT");
  EXPECT_EQ(element_of(xml, "data_protection_kind"), "ENCRYPT");
  EXPECT_EQ(element_of(xml, "min"), "0");
  EXPECT_EQ(element_of(xml, "max"), "101");
}

TEST(PermissionsXml, SaysWhoMayDoWhatWhereAndHowLong) {
  const std::string xml = permissions_xml(
      {"CN=laptop1", "robot1", {"stop_request", "team_plan"}, {"robot_pose"}, {kNow, kNow + std::chrono::days{1}}},
      {20, 21});

  EXPECT_EQ(element_of(xml, "subject_name"), "CN=laptop1");
  EXPECT_EQ(element_of(xml, "not_before"), "2027-01-15T08:00:00");
  EXPECT_EQ(element_of(xml, "not_after"), "2027-01-16T08:00:00");
  const std::string rule = element_of(xml, "allow_rule");
  EXPECT_EQ(element_of(rule, "min"), "20");
  EXPECT_EQ(element_of(rule, "max"), "21");
  EXPECT_EQ(texts_of(element_of(rule, "publish"), "topic"), (std::vector<std::string>{"stop_request", "team_plan"}));
  EXPECT_EQ(texts_of(element_of(rule, "subscribe"), "topic"), std::vector<std::string>{"robot_pose"});
  EXPECT_EQ(texts_of(rule, "partition"), (std::vector<std::string>{"robot1", "robot1"}));
  EXPECT_EQ(element_of(xml, "default"), "DENY");
}

TEST(TextsOf, GivesEachElementWithoutBlanksAndComments) {
  EXPECT_EQ(texts_of("<a> one\n</a><!-- <a>none</a> --><a>two</a><a>open", "a"),
            (std::vector<std::string>{"one", "two"}));
  EXPECT_TRUE(texts_of("", "a").empty());
  EXPECT_EQ(element_of("<b/>", "a"), "");
}

TEST(DocumentTime, IsUtcThereAndBack) {
  EXPECT_EQ(text_of(kNow), "2027-01-15T08:00:00");
  EXPECT_EQ(time_of("2027-01-15T08:00:00"), kNow);
  EXPECT_EQ(time_of("2027-01-15T08:00:00Z"), kNow);
  EXPECT_THROW((void)time_of("tomorrow"), std::runtime_error);
  EXPECT_THROW((void)time_of(""), std::runtime_error);
}

}  // namespace
}  // namespace tandem::security
