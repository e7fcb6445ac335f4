#pragma once

#include <cstdint>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <memory>
#include <vector>

#include "services/bus/mailbox.hpp"

namespace tandem::bus {

/// A sample on its way through Fast DDS: the payload as it is, and its key where it is known.
struct RawPayload {
  std::vector<std::uint8_t> bytes;
  KeyHash key{};
  bool key_known = false;
};

/// Carries the payload of any type unchanged; decoding happens in the service's thread, never in the reader's.
class RawType final : public eprosima::fastdds::dds::TopicDataType {
 public:
  using MakeInner = std::unique_ptr<eprosima::fastdds::dds::TopicDataType> (*)();

  /// What `make_inner` makes gives name, keyedness and the key of a received sample (Fast DDS 2.9.1 takes it from the
  /// payload).
  explicit RawType(MakeInner make_inner);

  bool serialize(void* data, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override;
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override;
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override;
  void* createData() override;
  void deleteData(void* data) override;
  bool getKey(void* data, eprosima::fastrtps::rtps::InstanceHandle_t* handle, bool force_md5) override;
  bool is_bounded() const override { return false; }
  bool is_plain() const override { return false; }

 private:
  MakeInner make_inner_;
};

}  // namespace tandem::bus
