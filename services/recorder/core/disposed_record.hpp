#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "services/recorder/core/mcap_records.hpp"

/// How a recording keeps that an instance of a keyed topic has ended. An end has no payload, so it cannot be a message
/// of the topic's own channel: it is one of the channel `<topic>#disposed`, message encoding `tandem_key`, whose data
/// is the 16 bytes of the instance's DDS key hash. Samples themselves need no key beside them: it is in their payload.
namespace tandem::recorder {

inline constexpr std::string_view kDisposedSuffix = "#disposed";
inline constexpr const char* kDisposedEncoding = "tandem_key";

using KeyBytes = std::array<std::uint8_t, 16>;

/// The topic whose instances `channel_topic` tells the end of; none for an ordinary topic.
[[nodiscard]] inline std::optional<std::string> disposed_topic(std::string_view channel_topic) {
  if (!channel_topic.ends_with(kDisposedSuffix)) return std::nullopt;
  return std::string{channel_topic.substr(0, channel_topic.size() - kDisposedSuffix.size())};
}

/// The key in the data of such a message.
[[nodiscard]] inline std::optional<KeyBytes> disposed_key(mcap::ByteView data) {
  KeyBytes key{};
  if (data.size() != key.size()) return std::nullopt;
  for (std::size_t i = 0; i < key.size(); ++i) key[i] = data[i];
  return key;
}

}  // namespace tandem::recorder
