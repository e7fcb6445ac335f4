#include "services/bus/handshake_watch.hpp"

#include <gtest/gtest.h>

namespace tandem::bus {
namespace {

namespace rtps = eprosima::fastrtps::rtps;

rtps::GUID_t guid_of(int number) {
  rtps::GUID_t guid;
  guid.guidPrefix.value[0] = static_cast<rtps::octet>(number % 256);
  guid.guidPrefix.value[1] = static_cast<rtps::octet>(number / 256);
  guid.entityId = rtps::c_EntityId_RTPSParticipant;
  return guid;
}

/// What Fast DDS tells of participants.
class Rumour {
 public:
  explicit Rumour(HandshakeWatch& watch) : watch_(watch) {}
  /// `authority`: of its certificate; empty without one.
  void discovered(int number, const std::string& name, const std::string& authority = "") {
    tell(rtps::ParticipantDiscoveryInfo::DISCOVERED_PARTICIPANT, number, name, authority);
  }
  void gone(int number) { tell(rtps::ParticipantDiscoveryInfo::DROPPED_PARTICIPANT, number, "", ""); }
  void authenticated(int number, bool well) {
    rtps::ParticipantAuthenticationInfo info;
    info.guid = guid_of(number);
    info.status = well ? rtps::ParticipantAuthenticationInfo::AUTHORIZED_PARTICIPANT
                       : rtps::ParticipantAuthenticationInfo::UNAUTHORIZED_PARTICIPANT;
    watch_.authenticated(info);
  }

 private:
  void tell(rtps::ParticipantDiscoveryInfo::DISCOVERY_STATUS status, int number, const std::string& name,
            const std::string& authority) {
    rtps::ParticipantProxyData data{rtps::RTPSParticipantAllocationAttributes{}};
    data.m_guid = guid_of(number);
    data.m_participantName = name;
    if (!authority.empty()) {
      data.identity_token_.class_id("DDS:Auth:PKI-DH:1.0");
      data.identity_token_.properties().emplace_back("dds.ca.sn", authority);
    }
    rtps::ParticipantDiscoveryInfo info{data};
    info.status = status;
    watch_.discovered(info);
  }
  HandshakeWatch& watch_;
};

TEST(HandshakeWatch, ASecuredSideNamesWhoHasNoCertificateAndWhoseDoesNotHold) {
  const ManualClock clock;
  HandshakeWatch watch{true, clock};
  Rumour rumour{watch};
  rumour.discovered(1, "relay@laptop1", "CN=ours");
  rumour.authenticated(1, true);
  rumour.authenticated(2, false);  // told before it was discovered
  rumour.discovered(2, "relay@plain");
  rumour.discovered(3, "relay@foreign", "CN=theirs");
  rumour.authenticated(3, false);

  const auto refused = watch.refused();
  ASSERT_EQ(refused.size(), 2U);
  EXPECT_EQ(refused[0].name, "relay@plain");
  EXPECT_EQ(refused[0].reason, "it has no certificate: its link is not secured");
  EXPECT_EQ(refused[1].name, "relay@foreign");
  EXPECT_EQ(refused[1].reason, "its certificate of the authority \"CN=theirs\" or its permissions do not hold here");
}

TEST(HandshakeWatch, AnOpenSideNamesWhoIsSecured) {
  const ManualClock clock;
  HandshakeWatch watch{false, clock};
  Rumour rumour{watch};
  rumour.discovered(1, "relay@open");
  rumour.discovered(2, "relay@secured", "CN=ours");

  const auto refused = watch.refused();
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].name, "relay@secured");
  EXPECT_EQ(refused[0].reason, "its link is secured, and this host's is not");
}

TEST(HandshakeWatch, NamesWhoHasNotFinishedTheHandshakeInFiveSeconds) {
  ManualClock clock;
  HandshakeWatch watch{true, clock};
  Rumour rumour{watch};
  rumour.discovered(1, "relay@slow", "CN=ours");
  clock.advance(std::chrono::seconds{4});
  EXPECT_TRUE(watch.refused().empty());
  clock.advance(std::chrono::seconds{2});
  ASSERT_EQ(watch.refused().size(), 1U);
  EXPECT_TRUE(watch.refused()[0].reason.starts_with("no handshake: its certificate is of the authority \"CN=ours\""));
  rumour.authenticated(1, true);
  EXPECT_TRUE(watch.refused().empty());
}

TEST(HandshakeWatch, ForgetsWhoIsGoneOrIsLetInLater) {
  const ManualClock clock;
  HandshakeWatch watch{true, clock};
  Rumour rumour{watch};
  rumour.discovered(1, "relay@a", "CN=ours");
  rumour.authenticated(1, false);
  rumour.discovered(2, "relay@b");
  rumour.authenticated(2, false);
  ASSERT_EQ(watch.refused().size(), 2U);

  rumour.authenticated(1, true);
  rumour.gone(2);
  EXPECT_TRUE(watch.refused().empty());
}

TEST(HandshakeWatch, AThousandStrangersFillNeitherMemoryNorLog) {
  const ManualClock clock;
  HandshakeWatch watch{true, clock};
  Rumour rumour{watch};
  for (int i = 0; i < 1000; ++i) {
    rumour.discovered(i, std::string(200, '\n'));
    rumour.authenticated(i, false);
  }

  const auto refused = watch.refused();
  EXPECT_EQ(refused.size(), 4U);
  EXPECT_EQ(refused[0].name, std::string(60, '?'));
}

}  // namespace
}  // namespace tandem::bus
