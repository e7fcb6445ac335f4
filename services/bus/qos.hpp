#pragma once

#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/publisher/qos/PublisherQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <fastdds/dds/subscriber/qos/SubscriberQos.hpp>

#include "services/bus/bus.hpp"

/// The only place that turns a Delivery into DDS QoS. Every policy is set, with its reason; docs/network.md shows the
/// table.
namespace tandem::bus {

[[nodiscard]] eprosima::fastdds::dds::PublisherQos publisher_qos(const DomainOptions& options);
[[nodiscard]] eprosima::fastdds::dds::SubscriberQos subscriber_qos(const DomainOptions& options);
[[nodiscard]] eprosima::fastdds::dds::DataWriterQos writer_qos(Delivery delivery, const DomainOptions& options);
[[nodiscard]] eprosima::fastdds::dds::DataReaderQos reader_qos(Delivery delivery, const DomainOptions& options);

}  // namespace tandem::bus
