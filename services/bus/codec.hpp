#pragma once

#include <cstdint>
#include <cstring>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <optional>
#include <vector>

#include "services/bus/mailbox.hpp"

namespace tandem::bus {

/// `message` as CDR with its encapsulation header, little-endian.
template <class PubSubType>
[[nodiscard]] std::vector<std::uint8_t> encode(const typename PubSubType::type& message) {
  PubSubType type;
  auto* data = const_cast<typename PubSubType::type*>(&message);  // NOLINT: the generated interface is not const
  eprosima::fastrtps::rtps::SerializedPayload_t payload{type.getSerializedSizeProvider(data)()};
  if (!type.serialize(data, &payload)) return {};
  return {payload.data, payload.data + payload.length};
}

/// The message in `bytes`, or none if they are not a whole, well-formed one. Never throws: bytes come from outside.
template <class PubSubType>
[[nodiscard]] std::optional<typename PubSubType::type> decode(const std::vector<std::uint8_t>& bytes) {
  if (bytes.size() < 4) return std::nullopt;
  PubSubType type;
  eprosima::fastrtps::rtps::SerializedPayload_t payload{static_cast<std::uint32_t>(bytes.size())};
  std::memcpy(payload.data, bytes.data(), bytes.size());
  payload.length = static_cast<std::uint32_t>(bytes.size());
  typename PubSubType::type message;
  if (!type.deserialize(&payload, &message)) return std::nullopt;
  return message;
}

/// The key hash of `message`; all zero for a topic without key.
template <class PubSubType>
[[nodiscard]] KeyHash key_of(const typename PubSubType::type& message) {
  PubSubType type;
  KeyHash key{};
  if (!type.m_isGetKeyDefined) return key;
  auto* data = const_cast<typename PubSubType::type*>(&message);  // NOLINT: as above
  eprosima::fastrtps::rtps::InstanceHandle_t handle;
  if (type.getKey(data, &handle)) {
    for (std::size_t i = 0; i < key.size(); ++i) key[i] = handle.value[i];
  }
  return key;
}

}  // namespace tandem::bus
