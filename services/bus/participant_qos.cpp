#include "services/bus/participant_qos.hpp"

#include <fastdds/rtps/attributes/ServerAttributes.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fastdds/rtps/flowcontrol/FlowControllerDescriptor.hpp>
#include <memory>
#include <stdexcept>

namespace tandem::bus {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastrtps::Duration_t;

constexpr std::uint32_t kSocketBuffer = 1 << 20;
constexpr std::uint64_t kFlowPeriod_ms = 20;
constexpr std::uint32_t kFirstPort = 7400;
constexpr std::uint32_t kPortsOfADomain = 250;
constexpr std::uint32_t kFirstUnicastPort = 10;

rtps::Locator_t locator_of(const std::string& address, std::uint32_t port) {
  rtps::Locator_t locator;
  locator.kind = LOCATOR_KIND_UDPv4;
  locator.port = port;
  if (!rtps::IPLocator::isIPv4(address) || !rtps::IPLocator::setIPv4(locator, address)) {
    throw std::runtime_error("\"" + address + "\" is not an IPv4 address. See peers and servers in site.toml");
  }
  return locator;
}

/// As many bytes at a time as `options` lets through in 20 ms. On a secured link no more than one frame, more often: a
/// writer makes its fragments so that they pass, and there the transport would let larger ones through.
void limit_flow(dds::DomainParticipantQos& qos, const DomainOptions& options) {
  auto flow = std::make_shared<eprosima::fastdds::rtps::FlowControllerDescriptor>();
  flow->name = kLinkFlow;
  // Writers take turns: a plan does not wait for the whole of a map.
  flow->scheduler = eprosima::fastdds::rtps::FlowControllerSchedulerPolicy::ROUND_ROBIN;
  const double bytes_per_ms = options.bulk_rate_bps / 8.0 / 1000.0;
  const auto bytes = static_cast<std::int32_t>(bytes_per_ms * static_cast<double>(kFlowPeriod_ms));
  flow->max_bytes_per_period = std::max(bytes, static_cast<std::int32_t>(2 * kLinkDatagram));  // less would never fit
  flow->period_ms = kFlowPeriod_ms;
  if (options.security) {
    flow->max_bytes_per_period = kLinkDatagram;
    flow->period_ms = static_cast<std::uint64_t>(std::max(1.0, std::round(kLinkDatagram / bytes_per_ms)));
  }
  qos.flow_controllers().push_back(flow);
}

/// The participant whose address is on the list is the server of that place in it; all others are clients of all.
void use_servers(dds::WireProtocolConfigQos& wire, const DomainOptions& options) {
  auto& discovery = wire.builtin.discovery_config;
  discovery.discoveryProtocol = rtps::DiscoveryProtocol::CLIENT;
  discovery.discoveryServer_client_syncperiod = Duration_t{0, 200'000'000};  // default 450 ms: the wait of a newcomer
  for (std::size_t i = 0; i < options.servers.size(); ++i) {
    const auto locator = locator_of(options.servers[i], kServerPort);
    rtps::RemoteServerAttributes server;
    rtps::get_server_client_default_guidPrefix(static_cast<int>(i), server.guidPrefix);
    server.metatrafficUnicastLocatorList.push_back(locator);
    if (options.servers[i] == options.address) {
      discovery.discoveryProtocol = rtps::DiscoveryProtocol::SERVER;
      wire.prefix = server.guidPrefix;
      wire.builtin.metatrafficUnicastLocatorList.push_back(locator);
    } else {
      discovery.m_DiscoveryServers.push_back(server);
    }
  }
}

void use_peers(dds::WireProtocolConfigQos& wire, const DomainOptions& options) {
  auto& builtin = wire.builtin;
  const std::uint32_t port = kFirstPort + kPortsOfADomain * static_cast<std::uint32_t>(options.domain);
  // On loopback several relays share one host, and the group is heard: any id will do.
  const bool alone_on_its_host = options.address != "127.0.0.1";
  if (alone_on_its_host) wire.participant_id = kFirstLinkId;
  for (const auto& peer : options.peers) {
    if (!alone_on_its_host) {
      builtin.initialPeersList.push_back(locator_of(peer, 0));
      continue;
    }
    for (std::uint32_t id = kFirstLinkId; id < kFirstLinkId + kLinkIds; ++id) {
      builtin.initialPeersList.push_back(locator_of(peer, port + kFirstUnicastPort + 2 * id));
    }
  }
  if (options.discovery == Discovery::Auto) {
    // With its port: without one, Fast DDS 2.9.1 expands a multicast address like a unicast one.
    builtin.initialPeersList.push_back(locator_of("239.255.0.1", port));
  } else {
    // Listening at a unicast address that was given switches multicast off.
    builtin.metatrafficUnicastLocatorList.push_back(locator_of(options.address, 0));
  }
}

/// The builtin plugins of DDS Security.
void secure(dds::DomainParticipantQos& qos, const SecurityFiles& files) {
  const auto set = [&](const char* name, const std::string& value) {
    qos.properties().properties().emplace_back(name, value);
  };
  const auto set_file = [&](const char* name, const std::filesystem::path& file) {
    set(name, "file://" + file.string());
  };
  set("dds.sec.auth.plugin", "builtin.PKI-DH");
  set_file("dds.sec.auth.builtin.PKI-DH.identity_ca", files.authority);
  set_file("dds.sec.auth.builtin.PKI-DH.identity_certificate", files.certificate);
  set_file("dds.sec.auth.builtin.PKI-DH.private_key", files.key);
  set("dds.sec.access.plugin", "builtin.Access-Permissions");
  set_file("dds.sec.access.builtin.Access-Permissions.permissions_ca", files.authority);
  set_file("dds.sec.access.builtin.Access-Permissions.governance", files.governance);
  set_file("dds.sec.access.builtin.Access-Permissions.permissions", files.permissions);
  set("dds.sec.crypto.plugin", "builtin.AES-GCM-GMAC");
}

}  // namespace

Discovery discovery_of(std::string_view word) {
  if (word == "multicast") return Discovery::Multicast;
  if (word == "peers") return Discovery::Peers;
  if (word == "server") return Discovery::Server;
  return Discovery::Auto;
}

dds::DomainParticipantQos participant_qos(const DomainOptions& options) {
  const bool link = options.kind == DomainOptions::Kind::Link;
  dds::DomainParticipantQos qos;
  qos.name(options.participant);

  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList.push_back(options.address);
  udp->sendBufferSize = kSocketBuffer;
  udp->receiveBufferSize = kSocketBuffer;
  // On the air one lost fragment of a datagram loses all of it, so a datagram is one frame.
  if (link) udp->maxMessageSize = options.security ? kSecuredDatagram : kLinkDatagram;
  qos.transport().use_builtin_transports = false;  // no shared memory: what it leaves behind survives crashes
  qos.transport().user_transports.push_back(udp);

  auto& wire = qos.wire_protocol();
  auto& discovery = wire.builtin.discovery_config;
  discovery.leaseDuration = Duration_t{5, 0};  // equal everywhere: unequal leases leave endpoints unmatched
  discovery.leaseDuration_announcementperiod = Duration_t{1, 0};
  discovery.initial_announcements.count = 20;  // 4 s of them: each is lost as easily as anything else
  discovery.initial_announcements.period = Duration_t{0, 200'000'000};
  wire.builtin.avoid_builtin_multicast = true;  // announcements alone go to the group, where it works

  if (!link) return qos;
  limit_flow(qos, options);
  if (options.security) {
    assert(options.discovery != Discovery::Server);
    secure(qos, *options.security);
  }
  if (options.discovery == Discovery::Server) use_servers(wire, options);
  if (options.discovery == Discovery::Auto || options.discovery == Discovery::Peers) use_peers(wire, options);
  return qos;
}

}  // namespace tandem::bus
