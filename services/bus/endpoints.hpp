#pragma once

#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <functional>
#include <memory>

#include "services/bus/bus.hpp"
#include "services/bus/peer_watch.hpp"

/// Writers and readers of one participant, as the bus shows them. Throw std::runtime_error when Fast DDS refuses them.
namespace tandem::bus {

[[nodiscard]] std::unique_ptr<RawWriter> make_writer(eprosima::fastdds::dds::Publisher* publisher,
                                                     eprosima::fastdds::dds::Topic* topic,
                                                     const eprosima::fastdds::dds::DataWriterQos& qos,
                                                     const TopicInfo& info, PeerWatch& watch);

/// What a reader has of its bus.
struct ReaderContext {
  const Clock& clock;            ///< stamps what arrives
  PeerWatch& watch;              ///< is told of what is malformed
  std::function<void()> notify;  ///< called after something arrived, in the reader's thread
};

/// Fills `mailbox` with what arrives and is well-formed.
[[nodiscard]] std::unique_ptr<Subscription> make_subscription(eprosima::fastdds::dds::Subscriber* subscriber,
                                                              eprosima::fastdds::dds::Topic* topic,
                                                              const eprosima::fastdds::dds::DataReaderQos& qos,
                                                              const TopicInfo& info, std::shared_ptr<Mailbox> mailbox,
                                                              ReaderContext context);

}  // namespace tandem::bus
