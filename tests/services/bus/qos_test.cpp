#include "services/bus/qos.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <gtest/gtest.h>

#include "services/bus/participant_qos.hpp"

namespace tandem::bus {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastrtps::c_TimeInfinite;
using eprosima::fastrtps::Duration_t;

constexpr Delivery kAll[] = {Delivery::SensorStream, Delivery::State, Delivery::Bulk, Delivery::Command,
                             Delivery::Event};

DomainOptions on_link() {
  DomainOptions options;
  options.kind = DomainOptions::Kind::Link;
  options.participant = "relay@robot1";
  options.address = "10.0.0.1";
  return options;
}

DomainOptions on_host() {
  return {};
}

const eprosima::fastdds::rtps::UDPv4TransportDescriptor& transport_of(const dds::DomainParticipantQos& qos) {
  return dynamic_cast<const eprosima::fastdds::rtps::UDPv4TransportDescriptor&>(
      *qos.transport().user_transports.front());
}

TEST(Qos, WriterAndReaderOfEveryDeliveryFitTogether) {
  for (const auto& options : {on_host(), on_link()}) {
    for (const Delivery delivery : kAll) {
      const auto writer = writer_qos(delivery, options);
      const auto reader = reader_qos(delivery, options);
      EXPECT_EQ(writer.reliability().kind, reader.reliability().kind);
      EXPECT_EQ(writer.durability().kind, reader.durability().kind);
      EXPECT_EQ(writer.deadline().period, reader.deadline().period);
      EXPECT_EQ(writer.ownership().kind, reader.ownership().kind);
      EXPECT_EQ(writer.destination_order().kind, reader.destination_order().kind);
    }
  }
}

TEST(Qos, NothingBlocksAndNothingIsSharedInMemory) {
  for (const auto& options : {on_host(), on_link()}) {
    for (const Delivery delivery : kAll) {
      EXPECT_EQ(writer_qos(delivery, options).history().kind, dds::KEEP_LAST_HISTORY_QOS);
      EXPECT_EQ(writer_qos(delivery, options).data_sharing().kind(), dds::OFF);
      EXPECT_EQ(reader_qos(delivery, options).data_sharing().kind(), dds::OFF);
    }
  }
}

TEST(Qos, StatesAreLatchedStreamsAreNot) {
  for (const Delivery delivery : {Delivery::State, Delivery::Bulk}) {
    EXPECT_EQ(writer_qos(delivery, on_link()).durability().kind, dds::TRANSIENT_LOCAL_DURABILITY_QOS);
    EXPECT_EQ(writer_qos(delivery, on_link()).reliability().kind, dds::RELIABLE_RELIABILITY_QOS);
  }
  EXPECT_EQ(writer_qos(Delivery::SensorStream, on_link()).durability().kind, dds::VOLATILE_DURABILITY_QOS);
  EXPECT_EQ(writer_qos(Delivery::SensorStream, on_link()).reliability().kind, dds::BEST_EFFORT_RELIABILITY_QOS);
  EXPECT_EQ(writer_qos(Delivery::Event, on_link()).durability().kind, dds::VOLATILE_DURABILITY_QOS);
}

TEST(Qos, OnTheLinkADatagramIsOneFrameAndOnTheHostItMayBeLarge) {
  EXPECT_LE(transport_of(participant_qos(on_link())).maxMessageSize,
            1392U);  // WireGuard leaves 1420, with 28 of IP and UDP
  EXPECT_GT(transport_of(participant_qos(on_host())).maxMessageSize, 60'000U);
}

TEST(Qos, OnASecuredLinkAStateIsSentFrameByFrameAtTheSameRate) {
  DomainOptions options = on_link();
  options.security = security_files_in("/somewhere");
  options.bulk_rate_bps = 1.6e6;  // 1392 bytes each 7 ms
  const auto& flow = *participant_qos(options).flow_controllers().front();
  EXPECT_EQ(flow.max_bytes_per_period, 1392);
  EXPECT_EQ(flow.period_ms, 7U);
  EXPECT_EQ(transport_of(participant_qos(options)).maxMessageSize, kSecuredDatagram);
}

TEST(Qos, StatesOnTheLinkTakeNoMoreThanTheirRate) {
  DomainOptions options = on_link();
  options.bulk_rate_bps = 1.6e6;
  const auto& flow = *participant_qos(options).flow_controllers().front();
  const double bytes_per_s = flow.max_bytes_per_period * 1000.0 / static_cast<double>(flow.period_ms);
  EXPECT_NEAR(bytes_per_s, 200'000.0, 1'000.0);
  for (const Delivery delivery : {Delivery::State, Delivery::Bulk}) {
    EXPECT_STREQ(writer_qos(delivery, options).publish_mode().flow_controller_name, flow.name);
    EXPECT_EQ(writer_qos(delivery, options).publish_mode().kind, dds::ASYNCHRONOUS_PUBLISH_MODE);
  }
}

TEST(Qos, ALowRateStillLetsADatagramThrough) {
  DomainOptions options = on_link();
  options.bulk_rate_bps = 1.0;
  EXPECT_GT(participant_qos(options).flow_controllers().front()->max_bytes_per_period,
            static_cast<std::int32_t>(kLinkDatagram));
}

TEST(Qos, AnEventDiesWhenItsSenderHasGivenUpByTheSendersClockAlone) {
  EXPECT_EQ(writer_qos(Delivery::Event, on_link()).lifespan().duration, (Duration_t{10, 0}));
  EXPECT_EQ(reader_qos(Delivery::Event, on_link()).lifespan().duration, c_TimeInfinite);
}

TEST(Qos, AskingAgainTakesLongerForTheMapThanForAnythingElse) {
  const auto period = [](Delivery delivery) {
    return writer_qos(delivery, on_link()).reliable_writer_qos().times.heartbeatPeriod;
  };
  EXPECT_EQ(period(Delivery::Event), (Duration_t{0, 20'000'000}));
  EXPECT_EQ(period(Delivery::State), (Duration_t{0, 50'000'000}));
  EXPECT_EQ(period(Delivery::Bulk), (Duration_t{0, 200'000'000}));
}

TEST(Discovery, LeasesAreEqualOnEveryDomain) {
  for (const auto& options : {on_host(), on_link()}) {
    const auto discovery = participant_qos(options).wire_protocol().builtin.discovery_config;
    EXPECT_EQ(discovery.leaseDuration, (Duration_t{5, 0}));
    EXPECT_EQ(discovery.leaseDuration_announcementperiod, (Duration_t{1, 0}));
  }
}

TEST(Discovery, AutoAnnouncesToPeersAndToTheGroup) {
  DomainOptions options = on_link();
  options.domain = 2;
  options.discovery = Discovery::Auto;
  options.peers = {"10.0.0.2"};
  const auto qos = participant_qos(options);
  const auto& builtin = qos.wire_protocol().builtin;
  std::vector<std::uint32_t> ports;
  for (const auto& peer : builtin.initialPeersList) ports.push_back(peer.port);
  // The peer's ids 20, 21 and 22: 7400 + 2 x 250 + 10 + 2 x id; and the group.
  EXPECT_EQ(ports, (std::vector<std::uint32_t>{7'950, 7'952, 7'954, 7'900}));
  EXPECT_TRUE(builtin.metatrafficUnicastLocatorList.empty());  // the group is heard
}

TEST(Discovery, PeersHearNoGroup) {
  DomainOptions options = on_link();
  options.discovery = Discovery::Peers;
  options.peers = {"10.0.0.2"};
  const auto qos = participant_qos(options);
  EXPECT_EQ(qos.wire_protocol().builtin.initialPeersList.size(), 3U);
  EXPECT_EQ(qos.wire_protocol().builtin.metatrafficUnicastLocatorList.size(), 1U);
}

TEST(Discovery, WhoseAddressIsOnTheListOfServersIsOne) {
  DomainOptions options = on_link();
  options.discovery = Discovery::Server;
  options.servers = {"10.0.0.1", "10.0.0.2"};
  const auto server = participant_qos(options);
  EXPECT_EQ(server.wire_protocol().builtin.discovery_config.discoveryProtocol, rtps::DiscoveryProtocol::SERVER);
  EXPECT_EQ(server.wire_protocol().builtin.discovery_config.m_DiscoveryServers.size(), 1U);  // the other one

  options.address = "10.0.0.3";
  const auto client = participant_qos(options);
  EXPECT_EQ(client.wire_protocol().builtin.discovery_config.discoveryProtocol, rtps::DiscoveryProtocol::CLIENT);
  EXPECT_EQ(client.wire_protocol().builtin.discovery_config.m_DiscoveryServers.size(), 2U);
}

TEST(Discovery, AnAddressThatIsNoneIsRefusedByName) {
  DomainOptions options = on_link();
  options.discovery = Discovery::Auto;
  options.peers = {"robot.local"};
  try {
    std::ignore = participant_qos(options);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string{error.what()}.find("\"robot.local\" is not an IPv4 address"), std::string::npos);
  }
}

TEST(Discovery, WordsOfTheConfig) {
  EXPECT_EQ(discovery_of("auto"), Discovery::Auto);
  EXPECT_EQ(discovery_of("multicast"), Discovery::Multicast);
  EXPECT_EQ(discovery_of("peers"), Discovery::Peers);
  EXPECT_EQ(discovery_of("server"), Discovery::Server);
}

}  // namespace
}  // namespace tandem::bus
