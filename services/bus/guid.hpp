#pragma once

#include <fastdds/rtps/common/Guid.h>

#include <fastdds/dds/core/policy/QosPolicies.hpp>

#include "services/bus/core/endpoint_table.hpp"

/// What Fast DDS says of an endpoint, in our own words.
namespace tandem::bus {

[[nodiscard]] inline EndpointId to_endpoint_id(const eprosima::fastrtps::rtps::GUID_t& guid) {
  EndpointId id{};
  for (std::size_t i = 0; i < 12; ++i) id[i] = guid.guidPrefix.value[i];
  for (std::size_t i = 0; i < 4; ++i) id[12 + i] = guid.entityId.value[i];
  return id;
}

[[nodiscard]] inline std::int64_t to_ns(const eprosima::fastrtps::Duration_t& duration) {
  if (duration == eprosima::fastrtps::c_TimeInfinite) return EndpointQos::kNever;
  return duration.to_ns();
}

[[nodiscard]] inline EndpointQos to_endpoint_qos(const eprosima::fastdds::dds::ReliabilityQosPolicy& reliability,
                                                 const eprosima::fastdds::dds::DurabilityQosPolicy& durability,
                                                 const eprosima::fastdds::dds::OwnershipQosPolicy& ownership,
                                                 const eprosima::fastdds::dds::LivelinessQosPolicy& liveliness,
                                                 const eprosima::fastdds::dds::DeadlineQosPolicy& deadline) {
  namespace dds = eprosima::fastdds::dds;
  EndpointQos qos;
  qos.reliable = reliability.kind == dds::RELIABLE_RELIABILITY_QOS;
  qos.durability = static_cast<int>(durability.kind);
  qos.exclusive = ownership.kind == dds::EXCLUSIVE_OWNERSHIP_QOS;
  qos.liveliness = static_cast<int>(liveliness.kind);
  qos.deadline_ns = to_ns(deadline.period);
  qos.liveliness_lease_ns = to_ns(liveliness.lease_duration);
  return qos;
}

}  // namespace tandem::bus
