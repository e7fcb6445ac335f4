#include "services/bus/endpoints.hpp"

#include <atomic>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <limits>
#include <map>
#include <stdexcept>

#include "services/bus/raw_type.hpp"

namespace tandem::bus {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

WriterId to_writer_id(const rtps::GUID_t& guid) {
  WriterId id{};
  for (std::size_t i = 0; i < 12; ++i) id[i] = guid.guidPrefix.value[i];
  for (std::size_t i = 0; i < 4; ++i) id[12 + i] = guid.entityId.value[i];
  return id;
}

rtps::InstanceHandle_t to_handle(const KeyHash& key) {
  rtps::InstanceHandle_t handle;
  for (std::size_t i = 0; i < key.size(); ++i) handle.value[i] = key[i];
  return handle;
}

KeyHash to_key(const rtps::InstanceHandle_t& handle) {
  KeyHash key{};
  for (std::size_t i = 0; i < key.size(); ++i) key[i] = handle.value[i];
  return key;
}

/// Can Fast DDS carry it? It never returns from a write with a time before 1970, as a sample that came without any has.
bool is_stamp(Time time) {
  return time >= Time{} && time.time_since_epoch() < std::chrono::seconds{std::numeric_limits<std::int32_t>::max()};
}

class DdsWriter final : public RawWriter {
 public:
  DdsWriter(dds::Publisher* publisher, dds::DataWriter* writer, bool keyed)
      : publisher_(publisher), writer_(writer), keyed_(keyed) {}
  ~DdsWriter() override { publisher_->delete_datawriter(writer_); }

  bool write(const std::vector<std::uint8_t>& payload, const KeyHash& key, std::optional<Time> source_time) override {
    if (payload.empty()) return false;
    RawPayload raw{payload, key, keyed_};
    last_[key] = payload;
    const rtps::InstanceHandle_t handle = keyed_ ? to_handle(key) : rtps::InstanceHandle_t{};
    if (!source_time || !is_stamp(*source_time)) return writer_->write(&raw, handle) == ReturnCode_t::RETCODE_OK;
    const std::int64_t stamp_ns = to_stamp_ns(*source_time);
    eprosima::fastrtps::Time_t stamp;
    stamp.seconds = static_cast<std::int32_t>(stamp_ns / 1'000'000'000);
    stamp.nanosec = static_cast<std::uint32_t>(stamp_ns % 1'000'000'000);
    return writer_->write_w_timestamp(&raw, handle, stamp) == ReturnCode_t::RETCODE_OK;
  }

  bool dispose(const KeyHash& key) override {
    if (!keyed_) return false;
    RawPayload raw{last_.contains(key) ? last_[key] : std::vector<std::uint8_t>{0, 1, 0, 0}, key, true};
    last_.erase(key);
    return writer_->dispose(&raw, to_handle(key)) == ReturnCode_t::RETCODE_OK;
  }

  [[nodiscard]] int matched_readers() const override {
    dds::PublicationMatchedStatus status;
    writer_->get_publication_matched_status(status);
    return status.current_count;
  }

  bool wait_for_acknowledgments(Duration timeout) override {
    const auto count = timeout.count();
    return writer_->wait_for_acknowledgments(
               {static_cast<std::int32_t>(count / 1'000'000'000), static_cast<std::uint32_t>(count % 1'000'000'000)}) ==
           ReturnCode_t::RETCODE_OK;
  }

  [[nodiscard]] WriterId id() const override { return to_writer_id(writer_->guid()); }

 private:
  dds::Publisher* publisher_;
  dds::DataWriter* writer_;
  bool keyed_;
  std::map<KeyHash, std::vector<std::uint8_t>> last_;  // Fast DDS wants a sample to dispose of an instance
};

/// Moves samples from the reader into the mailbox, in the reader's thread, and does nothing else there.
class DdsSubscription final : public Subscription, private dds::DataReaderListener {
 public:
  DdsSubscription(dds::Subscriber* subscriber, dds::Topic* topic, const dds::DataReaderQos& qos,
                  std::shared_ptr<Mailbox> mailbox, const Clock& clock, std::function<void()> notify)
      : subscriber_(subscriber), mailbox_(std::move(mailbox)), clock_(clock), notify_(std::move(notify)) {
    dds::StatusMask mask = dds::StatusMask::data_available();
    mask << dds::StatusMask::subscription_matched();
    reader_ = subscriber_->create_datareader(topic, qos, this, mask);
    if (reader_ == nullptr) throw std::runtime_error("topic " + topic->get_name() + " cannot be read");
  }
  ~DdsSubscription() override { subscriber_->delete_datareader(reader_); }

  [[nodiscard]] int matched_writers() const override { return matched_; }

 private:
  void on_subscription_matched(dds::DataReader*, const dds::SubscriptionMatchedStatus& status) override {
    matched_ = status.current_count;
    notify_();
  }

  void on_data_available(dds::DataReader* reader) override {
    RawPayload payload;
    dds::SampleInfo info;
    while (reader->take_next_sample(&payload, &info) == ReturnCode_t::RETCODE_OK) {
      RawSample sample;
      if (info.valid_data) {
        sample.payload = std::move(payload.bytes);
      } else {
        sample.kind = info.instance_state == dds::NOT_ALIVE_DISPOSED_INSTANCE_STATE ? RawSample::Kind::Disposed
                                                                                    : RawSample::Kind::NoWriter;
      }
      sample.key = to_key(info.instance_handle);
      sample.writer = to_writer_id(rtps::iHandle2GUID(info.publication_handle));
      sample.source_time = from_stamp_ns(info.source_timestamp.to_ns());
      sample.received = clock_.now();
      mailbox_->put(std::move(sample));
      payload = {};
    }
    notify_();
  }

  dds::Subscriber* subscriber_;
  std::shared_ptr<Mailbox> mailbox_;  // shared with the reader's owner: a late sample must find it alive
  const Clock& clock_;
  std::function<void()> notify_;
  std::atomic<int> matched_ = 0;
  dds::DataReader* reader_ = nullptr;
};

}  // namespace

std::unique_ptr<RawWriter> make_writer(dds::Publisher* publisher, dds::Topic* topic, const dds::DataWriterQos& qos,
                                       bool keyed) {
  dds::DataWriter* writer = publisher->create_datawriter(topic, qos);
  if (writer == nullptr) throw std::runtime_error("topic " + topic->get_name() + " cannot be written");
  return std::make_unique<DdsWriter>(publisher, writer, keyed);
}

std::unique_ptr<Subscription> make_subscription(dds::Subscriber* subscriber, dds::Topic* topic,
                                                const dds::DataReaderQos& qos, std::shared_ptr<Mailbox> mailbox,
                                                const Clock& clock, std::function<void()> notify) {
  return std::make_unique<DdsSubscription>(subscriber, topic, qos, std::move(mailbox), clock, std::move(notify));
}

}  // namespace tandem::bus
