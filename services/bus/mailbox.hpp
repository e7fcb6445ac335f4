#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "services/common/time.hpp"

namespace tandem::bus {

/// Identifies a writer on the bus across processes (its DDS GUID).
using WriterId = std::array<std::uint8_t, 16>;
/// Identifies an instance of a keyed topic (its DDS key hash); all zero where there is no key.
using KeyHash = std::array<std::uint8_t, 16>;

/// A sample as it travels: the CDR payload with its 4-byte encapsulation header.
struct RawSample {
  enum class Kind {
    Data,
    Disposed,    ///< its writer ended the instance
    NoWriter,    ///< the instance's last writer is gone: nobody keeps it up to date
    WriterBack,  ///< that writer is back, and what it wrote last still holds
  };
  Kind kind = Kind::Data;  ///< All others have no payload.
  std::vector<std::uint8_t> payload;
  KeyHash key{};
  WriterId writer{};
  Time source_time{};                 ///< stamped by the writer, its host's clock
  Time received{};                    ///< this host's monotonic mission time
  std::uint64_t sequence_number = 0;  ///< of the writer, without gaps unless samples were lost
  bool writer_alive = true;           ///< false once the instance has no writer: what a State says may have changed
};

/// A decoded sample.
template <class Message>
struct Received {
  Message message;
  Time received{};
  Time source_time{};
  WriterId writer{};
  bool writer_alive = true;  ///< false once the instance has no writer: what a State says may have changed
};

/// What a reader's listener fills and a service empties. Thread-safe.
class Mailbox {
 public:
  virtual ~Mailbox() = default;
  virtual void put(RawSample sample) = 0;
};

/// Keeps the newest sample of each instance until it is disposed of; one without a writer is marked.
class LatestBox final : public Mailbox {
 public:
  void put(RawSample sample) override;
  [[nodiscard]] std::vector<RawSample> each() const;      ///< one per instance
  [[nodiscard]] std::optional<RawSample> newest() const;  ///< over all instances
  /// The newest sample if one came since the last call.
  [[nodiscard]] std::optional<RawSample> take_new();
  [[nodiscard]] std::vector<KeyHash> gone() const;  ///< instances disposed or without a writer
  [[nodiscard]] std::uint64_t count() const;        ///< samples ever put

 private:
  void mark(const KeyHash& key, bool writer_alive);

  mutable std::mutex mutex_;
  std::map<KeyHash, RawSample> live_;
  std::map<KeyHash, RawSample::Kind> gone_;
  std::optional<RawSample> newest_;
  bool fresh_ = false;
  std::uint64_t count_ = 0;
};

/// Keeps every sample in order of arrival, up to a limit; the oldest go first and are counted.
class InOrderBox final : public Mailbox {
 public:
  explicit InOrderBox(std::size_t limit) : limit_(limit) {}
  void put(RawSample sample) override;
  [[nodiscard]] std::vector<RawSample> take();
  [[nodiscard]] std::uint64_t dropped() const;

 private:
  mutable std::mutex mutex_;
  std::deque<RawSample> samples_;
  std::size_t limit_;
  std::uint64_t dropped_ = 0;
};

}  // namespace tandem::bus
