#pragma once

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <string>
#include <vector>

#include "services/bus/bus.hpp"

/// Fast DDS's own ways of configuration: who knows them keeps them, and the log says that they are at work.
///
/// XML profiles count on the link alone: no file may take a host's services off the loopback interface.
namespace tandem::bus {

/// The XML profile that replaces the QoS of the participant on the link; those of writers and readers are named as
/// their topic.
inline constexpr const char* kOutsideProfile = "tandem_link";

/// What is set from outside and changes a participant of `options`, each as "name=value".
[[nodiscard]] std::vector<std::string> outside_settings(const DomainOptions& options);

/// Throws std::runtime_error where such a setting would break DDS Security: silently, if it was left to Fast DDS.
void refuse_what_breaks_security(const DomainOptions& options);

/// Replaces `qos` where a profile says so, but never what secures the link; true if one did.
bool has_outside_profile(eprosima::fastdds::dds::DomainParticipantFactory& factory, const DomainOptions& options,
                         eprosima::fastdds::dds::DomainParticipantQos& qos);
bool has_outside_profile(const eprosima::fastdds::dds::Publisher& publisher, const std::string& topic,
                         const DomainOptions& options, eprosima::fastdds::dds::DataWriterQos& qos);
bool has_outside_profile(const eprosima::fastdds::dds::Subscriber& subscriber, const std::string& topic,
                         const DomainOptions& options, eprosima::fastdds::dds::DataReaderQos& qos);

}  // namespace tandem::bus
