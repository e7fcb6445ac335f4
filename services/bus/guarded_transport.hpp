#pragma once

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <functional>
#include <string>

#include "services/bus/core/rtps_guard.hpp"

namespace tandem::bus {

/// Hears of each datagram that was dropped, and of the address it came from; on threads of Fast DDS.
using DatagramDropped = std::function<void(const std::string& from, RtpsFault fault)>;

/// Has an RtpsGuard judge all that comes through the transports that `qos` names; what it refuses is dropped. Builtin
/// transports, which a profile of Fast DDS may ask for, are not guarded.
void guard_transports(eprosima::fastdds::dds::DomainParticipantQos& qos, bool secured, const DatagramDropped& dropped);

}  // namespace tandem::bus
