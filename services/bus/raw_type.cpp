#include "services/bus/raw_type.hpp"

#include <algorithm>
#include <cstring>

namespace tandem::bus {

using eprosima::fastrtps::rtps::InstanceHandle_t;
using eprosima::fastrtps::rtps::SerializedPayload_t;

RawType::RawType(MakeInner make_inner) : make_inner_(make_inner) {
  const auto inner = make_inner_();
  setName(inner->getName());
  m_typeSize = 256;  // a first guess; the histories grow as payloads need
  m_isGetKeyDefined = inner->m_isGetKeyDefined;
  auto_fill_type_object(false);
  auto_fill_type_information(false);  // else Cyclone DDS refuses the endpoint
}

bool RawType::serialize(void* data, SerializedPayload_t* payload) {
  const auto& bytes = static_cast<RawPayload*>(data)->bytes;
  if (bytes.size() > payload->max_size) return false;
  std::memcpy(payload->data, bytes.data(), bytes.size());
  payload->length = static_cast<std::uint32_t>(bytes.size());
  payload->encapsulation = bytes.size() > 1 && bytes[1] == 1 ? CDR_LE : CDR_BE;
  return true;
}

bool RawType::deserialize(SerializedPayload_t* payload, void* data) {
  auto& raw = *static_cast<RawPayload*>(data);
  raw.bytes.assign(payload->data, payload->data + payload->length);
  raw.key_known = false;
  return true;
}

std::function<std::uint32_t()> RawType::getSerializedSizeProvider(void* data) {
  return [data] { return static_cast<std::uint32_t>(static_cast<RawPayload*>(data)->bytes.size()); };
}

void* RawType::createData() {
  return new RawPayload;
}

void RawType::deleteData(void* data) {
  delete static_cast<RawPayload*>(data);
}

bool RawType::getKey(void* data, InstanceHandle_t* handle, bool force_md5) {
  if (!m_isGetKeyDefined) return false;
  auto& raw = *static_cast<RawPayload*>(data);
  if (raw.key_known) {
    for (std::size_t i = 0; i < raw.key.size(); ++i) handle->value[i] = raw.key[i];
    return true;
  }
  SerializedPayload_t payload{static_cast<std::uint32_t>(raw.bytes.size())};
  std::copy(raw.bytes.begin(), raw.bytes.end(), payload.data);
  payload.length = static_cast<std::uint32_t>(raw.bytes.size());
  // A new one each time: generated code leaves the bytes between two keys as they were, from another message, and they
  // count in the hash.
  const auto inner = make_inner_();
  void* message = inner->createData();
  const bool known = inner->deserialize(&payload, message) && inner->getKey(message, handle, force_md5);
  inner->deleteData(message);
  // Fast DDS 2.9.1 aborts the process when a reader cannot tell a sample's key: what is malformed shares one.
  for (std::size_t i = 0; !known && i < 16; ++i) handle->value[i] = 0xFF;
  return true;
}

}  // namespace tandem::bus
