#include "services/bus/outside_settings.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fstream>

#include "services/bus/participant_qos.hpp"
#include "services/bus/qos.hpp"
#include "tests/support/domain_lease.hpp"
#include "tests/support/temporary_folder.hpp"

// Fast DDS reads its profiles once in a process: these tests are a program of their own, each test a process.
namespace tandem::bus {
namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::Duration_t;

constexpr const char* kProfiles = R"(<?xml version="1.0" encoding="UTF-8" ?>
<profiles xmlns="http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles">
  <participant profile_name="tandem_link">
    <rtps>
      <builtin>
        <discovery_config>
          <leaseDuration><sec>7</sec></leaseDuration>
        </discovery_config>
      </builtin>
    </rtps>
  </participant>
  <data_writer profile_name="robot_pose">
    <qos><reliability><kind>RELIABLE</kind></reliability></qos>
  </data_writer>
</profiles>
)";

DomainOptions on_link() {
  DomainOptions options;
  options.kind = DomainOptions::Kind::Link;
  options.participant = "relay@robot1";
  return options;
}

class OutsideSettings : public ::testing::Test {
 protected:
  OutsideSettings() {
    std::ofstream{folder_ / "profiles.xml"} << kProfiles;
    setenv("FASTRTPS_DEFAULT_PROFILES_FILE", (folder_ / "profiles.xml").c_str(), 1);
  }
  ~OutsideSettings() override { unsetenv("FASTRTPS_DEFAULT_PROFILES_FILE"); }

  test::TemporaryFolder folder_;
};

TEST_F(OutsideSettings, AreNamedWithTheirValues) {
  setenv("ROS_DISCOVERY_SERVER", "10.0.0.1:11811", 1);
  const auto settings = outside_settings(on_link());
  EXPECT_EQ(settings,
            (std::vector<std::string>{"ROS_DISCOVERY_SERVER=10.0.0.1:11811",
                                      "FASTRTPS_DEFAULT_PROFILES_FILE=" + (folder_ / "profiles.xml").string()}));
  EXPECT_EQ(outside_settings({}), std::vector<std::string>{"ROS_DISCOVERY_SERVER=10.0.0.1:11811"});
  unsetenv("ROS_DISCOVERY_SERVER");
  EXPECT_TRUE(outside_settings({}).empty());
}

TEST_F(OutsideSettings, AProfileReplacesTheParticipantOfTheLinkAlone) {
  auto* factory = dds::DomainParticipantFactory::get_instance();
  auto link = participant_qos(on_link());
  ASSERT_TRUE(has_outside_profile(*factory, on_link(), link));
  EXPECT_EQ(link.wire_protocol().builtin.discovery_config.leaseDuration, (Duration_t{7, 0}));
  EXPECT_EQ(std::string{link.name().c_str()}, "relay@robot1");
  EXPECT_EQ(link.flow_controllers().size(), 1U);

  auto host = participant_qos({});
  EXPECT_FALSE(has_outside_profile(*factory, {}, host));
  EXPECT_EQ(host.wire_protocol().builtin.discovery_config.leaseDuration, (Duration_t{5, 0}));
}

TEST_F(OutsideSettings, AProfileDoesNotTakeSecurityOffTheLink) {
  auto options = on_link();
  options.security = security_files_in("/somewhere");
  auto qos = participant_qos(options);
  ASSERT_TRUE(has_outside_profile(*dds::DomainParticipantFactory::get_instance(), options, qos));
  EXPECT_EQ(qos.wire_protocol().builtin.discovery_config.leaseDuration, (Duration_t{7, 0}));
  EXPECT_EQ(*eprosima::fastrtps::rtps::PropertyPolicyHelper::find_property(qos.properties(), "dds.sec.auth.plugin"),
            "builtin.PKI-DH");
}

TEST_F(OutsideSettings, WhatBreaksSecurityIsRefusedThereAndObeyedElsewhere) {
  auto secured = on_link();
  secured.security = security_files_in("/somewhere");
  EXPECT_NO_THROW(refuse_what_breaks_security(secured));
  for (const char* variable : {"ROS_DISCOVERY_SERVER", "FASTDDS_STATISTICS"}) {
    setenv(variable, "anything", 1);
    EXPECT_NO_THROW(refuse_what_breaks_security(on_link()));
    try {
      refuse_what_breaks_security(secured);
      ADD_FAILURE() << variable << " was not refused";
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string{error.what()},
                std::string{variable} + " is set, and does not go with secure_link in site.toml: unset it");
    }
    unsetenv(variable);
  }
}

TEST_F(OutsideSettings, AProfileOfATopicsNameReplacesItsWriterOnTheLinkAlone) {
  const test::DomainLease domain{1};
  auto* factory = dds::DomainParticipantFactory::get_instance();
  factory->load_profiles();
  auto* participant = factory->create_participant(static_cast<dds::DomainId_t>(domain[0]), participant_qos({}));
  auto* publisher = participant->create_publisher(publisher_qos({}));
  auto pose = writer_qos(Delivery::SensorStream, on_link());
  EXPECT_TRUE(has_outside_profile(*publisher, "robot_pose", on_link(), pose));
  EXPECT_EQ(pose.reliability().kind, dds::RELIABLE_RELIABILITY_QOS);
  auto other = writer_qos(Delivery::SensorStream, on_link());
  EXPECT_FALSE(has_outside_profile(*publisher, "odometry", on_link(), other));
  EXPECT_FALSE(has_outside_profile(*publisher, "robot_pose", {}, other));
  EXPECT_EQ(other.reliability().kind, dds::BEST_EFFORT_RELIABILITY_QOS);
  participant->delete_contained_entities();
  factory->delete_participant(participant);
}

}  // namespace
}  // namespace tandem::bus
