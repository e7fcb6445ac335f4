#include "services/bus/endpoints.hpp"

#include <atomic>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <limits>
#include <map>
#include <mutex>
#include <stdexcept>

#include "services/bus/core/instance_writers.hpp"
#include "services/bus/guid.hpp"
#include "services/bus/payload_type.hpp"
#include "services/bus/raw_type.hpp"

namespace tandem::bus {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

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

template <class Qos>
Endpoint own_endpoint(const rtps::GUID_t& guid, Endpoint::Kind kind, const TopicInfo& info, const Qos& qos) {
  const auto type = info.make_type();
  Endpoint endpoint;
  endpoint.id = to_endpoint_id(guid);
  endpoint.kind = kind;
  endpoint.topic = info.name;
  endpoint.type = type->getName();
  endpoint.keyed = type->m_isGetKeyDefined;
  endpoint.qos =
      to_endpoint_qos(qos.reliability(), qos.durability(), qos.ownership(), qos.liveliness(), qos.deadline());
  return endpoint;
}

class DdsWriter final : public RawWriter {
 public:
  DdsWriter(dds::Publisher* publisher, dds::DataWriter* writer, const TopicInfo& info, PeerWatch& watch)
      : publisher_(publisher), writer_(writer), keyed_(info.make_type()->m_isGetKeyDefined), watch_(watch) {
    watch_.own_found(own_endpoint(writer->guid(), Endpoint::Kind::Writer, info, writer->get_qos()));
  }
  ~DdsWriter() override {
    watch_.own_gone(id());
    publisher_->delete_datawriter(writer_);
  }

  bool write(const std::vector<std::uint8_t>& payload, const KeyHash& key, std::optional<Time> source_time) override {
    if (payload.empty()) return false;
    Last& last = last_[key];
    last = {payload, source_time};
    return send(last, key);
  }

  bool dispose(const KeyHash& key) override {
    if (!keyed_) return false;
    const auto say = [&] {
      RawPayload raw = instance(key);
      return writer_->dispose(&raw, to_handle(key)) == ReturnCode_t::RETCODE_OK;
    };
    // Fast DDS ends no instance that was withdrawn, unless it is written once more.
    const bool is_said = say() || (renew(key) && say());
    last_.erase(key);
    return is_said;
  }

  bool withdraw(const KeyHash& key) override {
    if (!keyed_) return false;
    RawPayload raw = instance(key);
    return writer_->unregister_instance(&raw, to_handle(key)) == ReturnCode_t::RETCODE_OK;
  }

  bool renew(const KeyHash& key) override {
    const auto last = last_.find(key);
    return last != last_.end() && send(last->second, key);
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

  [[nodiscard]] WriterId id() const override { return to_endpoint_id(writer_->guid()); }

 private:
  struct Last {
    std::vector<std::uint8_t> payload;
    std::optional<Time> source_time;
  };

  bool send(const Last& last, const KeyHash& key) {
    RawPayload raw{last.payload, key, keyed_};
    const rtps::InstanceHandle_t handle = keyed_ ? to_handle(key) : rtps::InstanceHandle_t{};
    if (!last.source_time || !is_stamp(*last.source_time))
      return writer_->write(&raw, handle) == ReturnCode_t::RETCODE_OK;
    const std::int64_t stamp_ns = to_stamp_ns(*last.source_time);
    eprosima::fastrtps::Time_t stamp;
    stamp.seconds = static_cast<std::int32_t>(stamp_ns / 1'000'000'000);
    stamp.nanosec = static_cast<std::uint32_t>(stamp_ns % 1'000'000'000);
    return writer_->write_w_timestamp(&raw, handle, stamp) == ReturnCode_t::RETCODE_OK;
  }

  /// Fast DDS wants a sample to say which instance is meant.
  [[nodiscard]] RawPayload instance(const KeyHash& key) const {
    const auto last = last_.find(key);
    return {last != last_.end() ? last->second.payload : std::vector<std::uint8_t>{0, 1, 0, 0}, key, true};
  }

  dds::Publisher* publisher_;
  dds::DataWriter* writer_;
  bool keyed_;
  PeerWatch& watch_;
  std::map<KeyHash, Last> last_;
};

/// Moves samples from the reader into the mailbox, in the reader's thread, and does nothing else there.
class DdsSubscription final : public Subscription, private dds::DataReaderListener {
 public:
  DdsSubscription(dds::Subscriber* subscriber, dds::Topic* topic, const dds::DataReaderQos& qos, const TopicInfo& info,
                  std::shared_ptr<Mailbox> mailbox, ReaderContext context)
      : subscriber_(subscriber),
        topic_(info.name),
        type_(info),
        follows_writers_(info.delivery == Delivery::State || info.delivery == Delivery::Bulk),
        mailbox_(std::move(mailbox)),
        context_(std::move(context)) {
    dds::StatusMask mask = dds::StatusMask::data_available();
    mask << dds::StatusMask::subscription_matched();
    reader_ = subscriber_->create_datareader(topic, qos, this, mask);
    if (reader_ == nullptr) throw std::runtime_error("topic " + topic_ + " cannot be read");
    context_.watch.own_found(own_endpoint(reader_->guid(), Endpoint::Kind::Reader, info, qos));
  }
  ~DdsSubscription() override {
    context_.watch.own_gone(to_endpoint_id(reader_->guid()));
    subscriber_->delete_datareader(reader_);
  }

  [[nodiscard]] int matched_writers() const override { return matched_; }
  [[nodiscard]] std::uint64_t malformed() const override { return malformed_; }

 private:
  void on_subscription_matched(dds::DataReader*, const dds::SubscriptionMatchedStatus& status) override {
    matched_ = status.current_count;
    if (follows_writers_) {
      follow(to_endpoint_id(rtps::iHandle2GUID(status.last_publication_handle)), status.current_count_change > 0);
    }
    context_.notify();
  }

  void follow(const WriterId& writer, bool came) {
    const std::lock_guard lock{writers_mutex_};
    for (const auto& key : came ? writers_.back(writer) : writers_.lost(writer)) {
      RawSample sample;
      sample.kind = came ? RawSample::Kind::WriterBack : RawSample::Kind::NoWriter;
      sample.key = key;
      sample.writer = writer;
      sample.received = sample.source_time = context_.clock.now();
      mailbox_->put(std::move(sample));
    }
  }

  void on_data_available(dds::DataReader* reader) override {
    RawPayload payload;
    dds::SampleInfo info;
    while (reader->take_next_sample(&payload, &info) == ReturnCode_t::RETCODE_OK) {
      RawSample sample;
      sample.key = to_key(info.instance_handle);
      sample.writer = to_endpoint_id(rtps::iHandle2GUID(info.publication_handle));
      sample.source_time = from_stamp_ns(info.source_timestamp.to_ns());
      sample.received = context_.clock.now();
      sample.sequence_number = info.sample_identity.sequence_number().to64long();
      const bool wanted =
          info.valid_data ? take_data(sample, std::move(payload.bytes)) : take_end(sample, info.instance_state);
      if (wanted) mailbox_->put(std::move(sample));
      payload = {};
    }
    context_.notify();
  }

  bool take_data(RawSample& sample, std::vector<std::uint8_t>&& bytes) {
    const std::string_view problem = type_.problem_of(bytes);
    if (!problem.empty()) {
      ++malformed_;
      context_.watch.malformed(topic_, sample.writer, problem);
      return false;
    }
    sample.payload = std::move(bytes);
    const std::lock_guard lock{writers_mutex_};
    if (follows_writers_) writers_.wrote(sample.key, sample.writer);
    return true;
  }

  /// False while somebody else still writes the instance.
  bool take_end(RawSample& sample, dds::InstanceStateKind state) {
    const std::lock_guard lock{writers_mutex_};
    if (state == dds::NOT_ALIVE_DISPOSED_INSTANCE_STATE) {
      sample.kind = RawSample::Kind::Disposed;
      writers_.ended(sample.key);
      return true;
    }
    sample.kind = RawSample::Kind::NoWriter;
    return writers_.withdrew(sample.key, sample.writer) || state == dds::NOT_ALIVE_NO_WRITERS_INSTANCE_STATE;
  }

  dds::Subscriber* subscriber_;
  std::string topic_;
  PayloadType type_;
  bool follows_writers_;
  std::shared_ptr<Mailbox> mailbox_;  // shared with the reader's owner: a late sample must find it alive
  ReaderContext context_;
  std::atomic<int> matched_ = 0;
  std::atomic<std::uint64_t> malformed_ = 0;
  std::mutex writers_mutex_;  // matches and samples come on different threads
  InstanceWriters writers_;
  dds::DataReader* reader_ = nullptr;
};

}  // namespace

std::unique_ptr<RawWriter> make_writer(dds::Publisher* publisher, dds::Topic* topic, const dds::DataWriterQos& qos,
                                       const TopicInfo& info, PeerWatch& watch) {
  dds::DataWriter* writer = publisher->create_datawriter(topic, qos);
  if (writer == nullptr) throw std::runtime_error("topic " + topic->get_name() + " cannot be written");
  return std::make_unique<DdsWriter>(publisher, writer, info, watch);
}

std::unique_ptr<Subscription> make_subscription(dds::Subscriber* subscriber, dds::Topic* topic,
                                                const dds::DataReaderQos& qos, const TopicInfo& info,
                                                std::shared_ptr<Mailbox> mailbox, ReaderContext context) {
  return std::make_unique<DdsSubscription>(subscriber, topic, qos, info, std::move(mailbox), std::move(context));
}

}  // namespace tandem::bus
