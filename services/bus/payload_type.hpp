#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "idl/topics.hpp"
#include "services/bus/mailbox.hpp"

namespace tandem::bus {

/// The message type of a topic that is known only at run time: for those who copy payloads (relay, recorder, replayer).
class PayloadType {
 public:
  explicit PayloadType(const TopicInfo& topic)
      : make_type_(topic.make_type), type_(topic.make_type()), holds_nan_(topic.holds_nan) {}

  /// What is wrong with `payload`, for people; empty if it is a whole, well-formed message of the type. NaN is wrong
  /// but where the topic table says who judges it.
  [[nodiscard]] std::string_view problem_of(std::span<const std::uint8_t> payload) const;
  /// True if nothing is wrong with it.
  [[nodiscard]] bool is_well_formed(std::span<const std::uint8_t> payload) const { return problem_of(payload).empty(); }
  /// The key hash of the message in `payload`, all zero where the type has no key; none if it is not well-formed.
  [[nodiscard]] std::optional<KeyHash> key_of(std::span<const std::uint8_t> payload) const;

 private:
  std::unique_ptr<eprosima::fastdds::dds::TopicDataType> (*make_type_)();
  std::unique_ptr<eprosima::fastdds::dds::TopicDataType> type_;
  bool (*holds_nan_)(const void* message);
};

}  // namespace tandem::bus
