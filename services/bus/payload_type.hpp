#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "idl/topics.hpp"
#include "services/bus/mailbox.hpp"

namespace tandem::bus {

/// The message type of a topic that is known only at run time: for those who copy payloads (relay, recorder, replayer).
class PayloadType {
 public:
  explicit PayloadType(const TopicInfo& topic) : type_(topic.make_type()) {}

  /// True if `payload` is a whole, well-formed message of the type.
  [[nodiscard]] bool is_well_formed(std::span<const std::uint8_t> payload) const;
  /// The key hash of the message in `payload`, all zero where the type has no key; none if it is not well-formed.
  [[nodiscard]] std::optional<KeyHash> key_of(std::span<const std::uint8_t> payload) const;

 private:
  std::unique_ptr<eprosima::fastdds::dds::TopicDataType> type_;
};

}  // namespace tandem::bus
