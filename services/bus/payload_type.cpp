#include "services/bus/payload_type.hpp"

#include <algorithm>

namespace tandem::bus {
namespace {

using eprosima::fastdds::dds::TopicDataType;

constexpr std::size_t kEncapsulation = 4;          // bytes of the header of every payload
constexpr std::uint8_t kLastEncapsulation = 0x03;  // CDR and parameter lists, big and little endian

/// Calls `use(message)` with the message in `payload`. False if it is not well-formed, or what `use` returns.
template <typename Use>
bool with_message(TopicDataType& type, std::span<const std::uint8_t> payload, Use use) {
  if (payload.size() < kEncapsulation) return false;
  eprosima::fastrtps::rtps::SerializedPayload_t cdr{static_cast<std::uint32_t>(payload.size())};
  std::copy(payload.begin(), payload.end(), cdr.data);
  cdr.length = static_cast<std::uint32_t>(payload.size());
  void* message = type.createData();
  const bool good = type.deserialize(&cdr, message) && use(message);
  type.deleteData(message);
  return good;
}

}  // namespace

std::string_view PayloadType::problem_of(std::span<const std::uint8_t> payload) const {
  if (payload.size() < kEncapsulation) return "cut short";
  if (payload[0] != 0 || payload[1] > kLastEncapsulation) return "unknown encapsulation";
  bool holds_nan = false;
  const bool whole = with_message(*type_, payload, [&](void* message) {
    holds_nan = holds_nan_(message);
    return true;
  });
  if (!whole) return "cut short, or longer inside than it is";
  return holds_nan ? "a number is NaN" : "";
}

std::optional<KeyHash> PayloadType::key_of(std::span<const std::uint8_t> payload) const {
  KeyHash key{};
  eprosima::fastrtps::rtps::InstanceHandle_t handle;
  const auto type = make_type_();  // see RawType::getKey
  const bool known = with_message(
      *type, payload, [&](void* message) { return !type->m_isGetKeyDefined || type->getKey(message, &handle); });
  if (!known) return std::nullopt;
  for (std::size_t i = 0; type->m_isGetKeyDefined && i < key.size(); ++i) key[i] = handle.value[i];
  return key;
}

}  // namespace tandem::bus
