#include "services/recorder/recording_segment.hpp"

#include "services/recorder/core/schemas.hpp"

namespace tandem::recorder {

RecordingSegment::RecordingSegment(std::filesystem::path file, Time opened)
    : path_(std::move(file)),
      opened_(opened),
      file_(path_),
      writer_([this](mcap::ByteView record) { return file_.write(record); }, recording_header()),
      channels_(writer_) {}

bool RecordingSegment::write(const Arrival& arrival, const std::string& topic, const std::string& type) {
  const auto log_time = static_cast<std::uint64_t>(to_stamp_ns(arrival.received));
  const auto publish_time = static_cast<std::uint64_t>(to_stamp_ns(arrival.source_time));
  bool written = false;
  if (arrival.disposed) {
    const std::uint16_t channel = channels_.channel_of(topic + std::string{kDisposedSuffix}, "", "", kDisposedEncoding);
    written = channels_.write(channel, log_time, publish_time, arrival.key);
  } else {
    const std::uint16_t channel = channels_.channel_of(topic, type, idl_of(type));
    written = channels_.write(channel, log_time, publish_time, arrival.payload);
  }
  if (written) ++message_count_;
  return written;
}

bool RecordingSegment::finish() {
  if (!writer_.finish()) return false;
  file_.sync();
  return true;
}

}  // namespace tandem::recorder
