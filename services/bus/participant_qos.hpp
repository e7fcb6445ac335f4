#pragma once

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>

#include "services/bus/bus.hpp"

namespace tandem::bus {

/// The flow controller of States and Bulk on the link.
inline constexpr const char* kLinkFlow = "tandem_link";
/// Largest datagram on the link: what WireGuard leaves of a frame (1420), less the headers of IP and UDP (28).
inline constexpr std::uint32_t kLinkDatagram = 1392;
/// Largest datagram on a secured link. Fast DDS 2.9 sends each message of the handshake, which holds certificate and
/// permissions, in one datagram of at most this size; there IP has to make fragments. All that is long and comes later
/// is kept within kLinkDatagram by the flow controller.
inline constexpr std::uint32_t kSecuredDatagram = 6000;
/// Where a discovery server listens, as Fast DDS's own tools have it.
inline constexpr std::uint16_t kServerPort = 11811;

/// Ids of participants on a link whose peers are named: their ports are known, so that an announcement is a datagram
/// for each of these and not one for each of a dozen. More than one, as a participant that comes back takes the next.
inline constexpr int kFirstLinkId = 20;
inline constexpr int kLinkIds = 3;

/// Transport, discovery and flow control of a participant. Throws std::runtime_error on an address that is none.
[[nodiscard]] eprosima::fastdds::dds::DomainParticipantQos participant_qos(const DomainOptions& options);

}  // namespace tandem::bus
