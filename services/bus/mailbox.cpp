#include "services/bus/mailbox.hpp"

#include <utility>

namespace tandem::bus {

void LatestBox::put(RawSample sample) {
  const std::lock_guard lock{mutex_};
  ++count_;
  if (sample.kind == RawSample::Kind::Data) {
    gone_.erase(sample.key);
    newest_ = sample;
    live_[sample.key] = std::move(sample);
    fresh_ = true;
  } else if (sample.kind == RawSample::Kind::WriterBack) {
    gone_.erase(sample.key);
    mark(sample.key, true);
  } else if (sample.kind == RawSample::Kind::NoWriter) {
    gone_[sample.key] = sample.kind;
    mark(sample.key, false);
  } else {
    live_.erase(sample.key);
    gone_[sample.key] = sample.kind;
    if (newest_ && newest_->key == sample.key) newest_.reset();
  }
}

void LatestBox::mark(const KeyHash& key, bool writer_alive) {
  if (const auto known = live_.find(key); known != live_.end()) known->second.writer_alive = writer_alive;
  if (newest_ && newest_->key == key) newest_->writer_alive = writer_alive;
}

std::vector<RawSample> LatestBox::each() const {
  const std::lock_guard lock{mutex_};
  std::vector<RawSample> samples;
  samples.reserve(live_.size());
  for (const auto& [key, sample] : live_) samples.push_back(sample);
  return samples;
}

std::optional<RawSample> LatestBox::newest() const {
  const std::lock_guard lock{mutex_};
  return newest_;
}

std::optional<RawSample> LatestBox::take_new() {
  const std::lock_guard lock{mutex_};
  if (!fresh_) return std::nullopt;
  fresh_ = false;
  return newest_;
}

std::vector<KeyHash> LatestBox::gone() const {
  const std::lock_guard lock{mutex_};
  std::vector<KeyHash> keys;
  for (const auto& [key, kind] : gone_) keys.push_back(key);
  return keys;
}

std::uint64_t LatestBox::count() const {
  const std::lock_guard lock{mutex_};
  return count_;
}

void InOrderBox::put(RawSample sample) {
  const std::lock_guard lock{mutex_};
  if (samples_.size() >= limit_) {
    samples_.pop_front();
    ++dropped_;
  }
  samples_.push_back(std::move(sample));
}

std::vector<RawSample> InOrderBox::take() {
  const std::lock_guard lock{mutex_};
  std::vector<RawSample> taken{std::make_move_iterator(samples_.begin()), std::make_move_iterator(samples_.end())};
  samples_.clear();
  return taken;
}

std::uint64_t InOrderBox::dropped() const {
  const std::lock_guard lock{mutex_};
  return dropped_;
}

}  // namespace tandem::bus
