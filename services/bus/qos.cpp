#include "services/bus/qos.hpp"

#include "services/bus/participant_qos.hpp"

namespace tandem::bus {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastrtps::c_TimeInfinite;
using eprosima::fastrtps::c_TimeZero;
using eprosima::fastrtps::Duration_t;

constexpr int kEventDepth = 10;
constexpr int kLockstepDepth = 10'000;
constexpr int kMaxInstances = 1'000;
constexpr int kCommandLife_ms = 250;
constexpr int kEventLife_ms = 10'000;  // then its sender has given up, and says so: it must not arrive after all

Duration_t milliseconds(int value) {
  return {value / 1000, static_cast<std::uint32_t>(value % 1000) * 1'000'000U};
}

bool is_latched(Delivery delivery) {
  return delivery == Delivery::State || delivery == Delivery::Bulk;
}

bool is_reliable(Delivery delivery, Pace pace) {
  if (delivery == Delivery::SensorStream) return pace == Pace::Lockstep;
  return delivery != Delivery::Command;
}

int depth_of(Delivery delivery, Pace pace) {
  const bool every_sample = delivery == Delivery::SensorStream || delivery == Delivery::Event;
  if (pace == Pace::Lockstep && every_sample) return kLockstepDepth;
  return delivery == Delivery::Event ? kEventDepth : 1;
}

/// How reliable endpoints talk about what is missing.
struct Timing {
  int heartbeat_ms;           ///< A writer says what it has while something is unacknowledged; idle, it is silent.
  int nack_response_ms;       ///< From a reader's complaint to the repetition.
  int heartbeat_response_ms;  ///< From a heartbeat to the reader's answer.
  bool piggyback;             ///< A heartbeat with every full datagram.
};

Timing timing_of(Delivery delivery, const DomainOptions& options) {
  if (options.pace == Pace::Lockstep) return {5, 2, 0, true};  // replay waits for each answer
  if (delivery == Delivery::Event) return {20, 2, 2, false};   // few and small: ask at once, ask often
  if (options.kind == DomainOptions::Kind::Host) return {200, 5, 5, true};
  // On the link a round of question and answer must be longer than the queue in front of the air, or what is still
  // queued is sent again, and again: the map waits longer than a plan. A piggyback comes before its data has left.
  if (delivery == Delivery::Bulk) return {200, 20, 20, false};
  return {50, 5, 5, false};
}

template <class Qos>
void apply_common(Qos& qos, Delivery delivery, const DomainOptions& options) {
  qos.reliability().kind =
      is_reliable(delivery, options.pace) ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  qos.reliability().max_blocking_time = milliseconds(100);  // with keep-last nothing blocks but a lock
  qos.durability().kind = is_latched(delivery) ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;  // keep-all would block the writer when a reader is out of reach
  const int depth = depth_of(delivery, options.pace);
  qos.history().depth = depth;
  qos.resource_limits().max_instances = kMaxInstances;
  qos.resource_limits().max_samples_per_instance = depth;
  qos.resource_limits().max_samples = kMaxInstances * depth;
  qos.resource_limits().allocated_samples = 0;
  qos.resource_limits().extra_samples = 1;
  // Age and silence are judged by services and relay, who know what to do about them and whose clocks can be trusted.
  qos.deadline().period = c_TimeInfinite;
  qos.latency_budget().duration = c_TimeZero;
  qos.liveliness().kind = dds::AUTOMATIC_LIVELINESS_QOS;
  qos.liveliness().lease_duration = c_TimeInfinite;  // the participant's lease stands for all its writers
  // By source would compare the clocks of two hosts.
  qos.destination_order().kind = dds::BY_RECEPTION_TIMESTAMP_DESTINATIONORDER_QOS;
  qos.ownership().kind =
      dds::SHARED_OWNERSHIP_QOS;  // two writers are a fault that must be seen, not one that is hidden
  qos.data_sharing().off();       // leftovers in /dev/shm survive crashes, and there is no gain at our sizes
  // Not DYNAMIC_RESERVE: with it Fast DDS 2.9.1 drops a dispose, whose payload is empty.
  qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
}

template <class Qos>
Qos group_qos(const DomainOptions& options) {
  Qos qos;
  qos.presentation().access_scope = dds::INSTANCE_PRESENTATION_QOS;
  qos.presentation().coherent_access = false;
  qos.presentation().ordered_access = false;
  qos.entity_factory().autoenable_created_entities = true;
  for (const auto& partition : options.partitions) qos.partition().push_back(partition.c_str());
  return qos;
}

}  // namespace

dds::PublisherQos publisher_qos(const DomainOptions& options) {
  return group_qos<dds::PublisherQos>(options);
}

dds::SubscriberQos subscriber_qos(const DomainOptions& options) {
  return group_qos<dds::SubscriberQos>(options);
}

dds::DataWriterQos writer_qos(Delivery delivery, const DomainOptions& options) {
  const bool link = options.kind == DomainOptions::Kind::Link;
  dds::DataWriterQos qos;
  apply_common(qos, delivery, options);
  qos.lifespan().duration = c_TimeInfinite;
  if (delivery == Delivery::Command) qos.lifespan().duration = milliseconds(kCommandLife_ms);
  if (delivery == Delivery::Event && options.pace == Pace::RealTime) {
    qos.lifespan().duration = milliseconds(kEventLife_ms);
  }
  qos.ownership_strength().value = 0;
  qos.transport_priority().value = 0;                                      // Fast DDS 2.9.1 does nothing with it
  qos.writer_data_lifecycle().autodispose_unregistered_instances = false;  // a writer that ends is not "disposed"
  // A bulky State must not hold up a stream in the writing thread; the others are one datagram.
  qos.publish_mode().kind = is_latched(delivery) ? dds::ASYNCHRONOUS_PUBLISH_MODE : dds::SYNCHRONOUS_PUBLISH_MODE;
  if (link && is_latched(delivery)) qos.publish_mode().flow_controller_name = kLinkFlow;

  const Timing timing = timing_of(delivery, options);
  auto& reliable = qos.reliable_writer_qos();
  reliable.times.initialHeartbeatDelay = milliseconds(12);
  reliable.times.heartbeatPeriod = milliseconds(timing.heartbeat_ms);
  reliable.times.nackResponseDelay = milliseconds(timing.nack_response_ms);
  reliable.times.nackSupressionDuration = milliseconds(0);
  reliable.disable_heartbeat_piggyback = !timing.piggyback;
  reliable.disable_positive_acks.enabled = false;  // without them nobody knows whether a sample arrived
  return qos;
}

dds::DataReaderQos reader_qos(Delivery delivery, const DomainOptions& options) {
  dds::DataReaderQos qos;
  apply_common(qos, delivery, options);
  // A reader compares a sample's stamp with its own wall clock. On the link that is another host's stamp.
  const bool one_clock = options.kind == DomainOptions::Kind::Host;
  qos.lifespan().duration = one_clock && delivery == Delivery::Command ? milliseconds(kCommandLife_ms) : c_TimeInfinite;
  qos.time_based_filter().minimum_separation = c_TimeZero;  // the relay thins, each instance for itself
  qos.reader_data_lifecycle().autopurge_no_writer_samples_delay = c_TimeInfinite;
  qos.reader_data_lifecycle().autopurge_disposed_samples_delay = c_TimeInfinite;
  qos.expects_inline_qos(false);
  auto& times = qos.reliable_reader_qos().times;
  times.initialAcknackDelay = milliseconds(10);
  times.heartbeatResponseDelay = milliseconds(timing_of(delivery, options).heartbeat_response_ms);
  return qos;
}

}  // namespace tandem::bus
