#include "services/bus/qos.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

#include <memory>

namespace tandem::bus {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastrtps::Duration_t;

constexpr int kEventDepth = 10;
constexpr int kLockstepDepth = 10'000;
constexpr int kMaxInstances = 1'000;

Duration_t milliseconds(int value) {
  return {value / 1000, static_cast<std::uint32_t>(value % 1000) * 1'000'000U};
}

/// What one delivery asks for, the same for writer and reader.
struct Traits {
  bool reliable;
  bool latched;
  int depth;
};

Traits traits_of(Delivery delivery, Pace pace) {
  const bool lockstep = pace == Pace::Lockstep;
  switch (delivery) {
    case Delivery::SensorStream:
      return {lockstep, false, lockstep ? kLockstepDepth : 1};
    case Delivery::Command:
      return {false, false, 1};
    case Delivery::State:
      return {true, true, 1};
    case Delivery::Event:
      return {true, false, lockstep ? kLockstepDepth : kEventDepth};
  }
  return {false, false, 1};
}

template <class Qos>
void apply_common(Qos& qos, const Traits& traits) {
  qos.reliability().kind = traits.reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  qos.reliability().max_blocking_time = milliseconds(100);
  qos.durability().kind = traits.latched ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = traits.depth;
  qos.resource_limits().max_instances = kMaxInstances;
  qos.resource_limits().max_samples_per_instance = traits.depth;
  qos.resource_limits().max_samples = kMaxInstances * traits.depth;
  qos.resource_limits().allocated_samples = 0;
  qos.deadline().period = eprosima::fastrtps::c_TimeInfinite;
  qos.latency_budget().duration = eprosima::fastrtps::c_TimeZero;
  qos.liveliness().kind = dds::AUTOMATIC_LIVELINESS_QOS;
  qos.liveliness().lease_duration =
      eprosima::fastrtps::c_TimeInfinite;  // the participant's lease stands for all its writers
  qos.destination_order().kind = dds::BY_RECEPTION_TIMESTAMP_DESTINATIONORDER_QOS;
  qos.ownership().kind = dds::SHARED_OWNERSHIP_QOS;
  qos.data_sharing().off();  // leftovers in /dev/shm survive crashes, and there is no gain at our sizes
  // Not DYNAMIC_RESERVE: with it Fast DDS 2.9.1 drops a dispose, whose payload is empty.
  qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
}

}  // namespace

dds::DomainParticipantQos participant_qos(const DomainOptions& options) {
  dds::DomainParticipantQos qos;
  qos.name(options.participant);

  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList.push_back(options.address);
  udp->sendBufferSize = 1 << 20;
  udp->receiveBufferSize = 1 << 20;
  // On the air one lost fragment of a datagram loses all of it, so a datagram is one frame.
  if (options.kind == DomainOptions::Kind::Link) udp->maxMessageSize = 1400;
  udp->maxInitialPeersRange = 12;
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(udp);

  auto& discovery = qos.wire_protocol().builtin.discovery_config;
  discovery.leaseDuration = milliseconds(5000);  // equal everywhere: unequal leases leave endpoints unmatched
  discovery.leaseDuration_announcementperiod = milliseconds(1000);
  discovery.initial_announcements.count = 20;
  discovery.initial_announcements.period = milliseconds(200);

  if (options.kind == DomainOptions::Kind::Link && options.discovery != "multicast") {
    for (const auto& peer : options.peers) {
      rtps::Locator_t locator;
      locator.kind = LOCATOR_KIND_UDPv4;
      rtps::IPLocator::setIPv4(locator, peer);
      qos.wire_protocol().builtin.initialPeersList.push_back(locator);
    }
    if (options.discovery == "auto") {
      // With its port: without one, Fast DDS 2.9.1 expands a multicast address like a unicast one.
      rtps::Locator_t multicast;
      multicast.kind = LOCATOR_KIND_UDPv4;
      rtps::IPLocator::setIPv4(multicast, "239.255.0.1");
      multicast.port = static_cast<std::uint32_t>(7400 + 250 * options.domain);
      qos.wire_protocol().builtin.initialPeersList.push_back(multicast);
    }
  }
  return qos;
}

dds::PublisherQos publisher_qos(const DomainOptions& options) {
  dds::PublisherQos qos;
  for (const auto& partition : options.partitions) qos.partition().push_back(partition.c_str());
  return qos;
}

dds::SubscriberQos subscriber_qos(const DomainOptions& options) {
  dds::SubscriberQos qos;
  for (const auto& partition : options.partitions) qos.partition().push_back(partition.c_str());
  return qos;
}

dds::DataWriterQos writer_qos(Delivery delivery, const DomainOptions& options) {
  const Traits traits = traits_of(delivery, options.pace);
  dds::DataWriterQos qos;
  apply_common(qos, traits);
  qos.lifespan().duration = delivery == Delivery::Command ? milliseconds(250) : eprosima::fastrtps::c_TimeInfinite;
  qos.ownership_strength().value = 0;
  qos.writer_data_lifecycle().autodispose_unregistered_instances = false;  // a writer that ends is not "disposed"
  // A bulky State must not hold up a stream in the writing thread; the others are one datagram.
  qos.publish_mode().kind =
      delivery == Delivery::State ? dds::ASYNCHRONOUS_PUBLISH_MODE : dds::SYNCHRONOUS_PUBLISH_MODE;

  auto& times = qos.reliable_writer_qos().times;
  if (delivery == Delivery::Event || options.pace == Pace::Lockstep) {
    times.heartbeatPeriod = milliseconds(options.pace == Pace::Lockstep ? 5 : 50);
    times.nackResponseDelay = milliseconds(2);
    qos.reliable_writer_qos().disable_heartbeat_piggyback = options.pace != Pace::Lockstep;
  } else {
    times.heartbeatPeriod = milliseconds(200);
    times.nackResponseDelay = milliseconds(options.kind == DomainOptions::Kind::Link ? 20 : 5);
    qos.reliable_writer_qos().disable_heartbeat_piggyback = options.kind == DomainOptions::Kind::Link;
  }
  times.nackSupressionDuration = milliseconds(0);
  return qos;
}

dds::DataReaderQos reader_qos(Delivery delivery, const DomainOptions& options) {
  const Traits traits = traits_of(delivery, options.pace);
  dds::DataReaderQos qos;
  apply_common(qos, traits);
  qos.lifespan().duration = delivery == Delivery::Command ? milliseconds(250) : eprosima::fastrtps::c_TimeInfinite;
  qos.time_based_filter().minimum_separation = eprosima::fastrtps::c_TimeZero;
  qos.reader_data_lifecycle().autopurge_no_writer_samples_delay = eprosima::fastrtps::c_TimeInfinite;
  qos.reader_data_lifecycle().autopurge_disposed_samples_delay = eprosima::fastrtps::c_TimeInfinite;
  auto& times = qos.reliable_reader_qos().times;
  times.initialAcknackDelay = milliseconds(10);
  times.heartbeatResponseDelay = milliseconds(options.pace == Pace::Lockstep ? 0 : delivery == Delivery::Event ? 2 : 5);
  return qos;
}

}  // namespace tandem::bus
