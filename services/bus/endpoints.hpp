#pragma once

#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <functional>
#include <memory>

#include "services/bus/bus.hpp"

/// Writers and readers of one participant, as the bus shows them. Throw std::runtime_error when Fast DDS refuses them.
namespace tandem::bus {

[[nodiscard]] std::unique_ptr<RawWriter> make_writer(eprosima::fastdds::dds::Publisher* publisher,
                                                     eprosima::fastdds::dds::Topic* topic,
                                                     const eprosima::fastdds::dds::DataWriterQos& qos, bool keyed);

/// Fills `mailbox` with what arrives, stamped by `clock`, and calls `notify` afterwards, in the reader's thread.
[[nodiscard]] std::unique_ptr<Subscription> make_subscription(eprosima::fastdds::dds::Subscriber* subscriber,
                                                              eprosima::fastdds::dds::Topic* topic,
                                                              const eprosima::fastdds::dds::DataReaderQos& qos,
                                                              std::shared_ptr<Mailbox> mailbox, const Clock& clock,
                                                              std::function<void()> notify);

}  // namespace tandem::bus
