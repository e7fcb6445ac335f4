#include "services/simulator/core/hardware_fault.hpp"

#include <array>
#include <utility>

namespace tandem::simulator {
namespace {

constexpr std::array<std::pair<HardwareFault, std::string_view>, 8> kNames{{
    {HardwareFault::None, "none"},
    {HardwareFault::Off, "off"},
    {HardwareFault::Stuck, "stuck"},
    {HardwareFault::Garbage, "garbage"},
    {HardwareFault::Wrong, "wrong"},
    {HardwareFault::Slow, "slow"},
    {HardwareFault::Delayed, "delayed"},
    {HardwareFault::Intermittent, "intermittent"},
}};

constexpr std::uint64_t kEvery = 4;
constexpr Duration kDelay = std::chrono::milliseconds{400};
constexpr Duration kInAndOut = std::chrono::seconds{1};

char random_byte(Rng& rng) {
  return static_cast<char>(rng.bits() & 0xFF);
}

}  // namespace

std::string_view name_of(HardwareFault fault) {
  for (const auto& [one, name] : kNames) {
    if (one == fault) return name;
  }
  return "none";
}

std::optional<HardwareFault> hardware_fault(std::string_view wanted) {
  for (const auto& [fault, name] : kNames) {
    if (name == wanted) return fault;
  }
  return std::nullopt;
}

std::string hardware_fault_names() {
  std::string all;
  for (const auto& [fault, name] : kNames) all += (all.empty() ? "" : ", ") + std::string{name};
  return all;
}

void FaultyLine::set(HardwareFault fault, Time now) {
  fault_ = fault;
  since_ = now;
  messages_ = 0;
  was_joined_ = fault != HardwareFault::Off;
  held_.clear();
}

bool FaultyLine::is_joined(Time now) const {
  if (fault_ == HardwareFault::Off) return false;
  return fault_ != HardwareFault::Intermittent || (now - since_) / kInAndOut % 2 == 1;
}

void FaultyLine::add_noise(std::string& bytes) {
  constexpr std::size_t kMostGarbage = 40;
  if (rng_.uniform() < noise_) bytes[rng_.index(bytes.size())] ^= static_cast<char>(1 + rng_.index(255));
  if (rng_.uniform() < noise_) {
    std::string garbage(1 + rng_.index(kMostGarbage), '\0');
    for (char& byte : garbage) byte = random_byte(rng_);
    bytes.insert(0, garbage);
  }
}

std::string FaultyLine::pass(std::string bytes, Time now) {
  if (bytes.empty()) return {};
  const bool was_joined = std::exchange(was_joined_, is_joined(now));
  if (!was_joined_) return was_joined ? bytes.substr(0, bytes.size() / 2) : std::string{};
  if (fault_ == HardwareFault::Garbage) {
    for (char& byte : bytes) byte = random_byte(rng_);
  }
  if (noise_ > 0.0) add_noise(bytes);
  if (fault_ == HardwareFault::Delayed) {
    held_.push_back({now + kDelay, std::move(bytes)});
    return {};
  }
  return bytes;
}

std::string FaultyLine::pass_message(std::string bytes, Time now) {
  if (bytes.empty()) return {};
  const bool left_out = fault_ == HardwareFault::Slow && messages_++ % kEvery != 0;
  return left_out ? std::string{} : pass(std::move(bytes), now);
}

std::string FaultyLine::due(Time now) {
  std::string bytes;
  for (; !held_.empty() && held_.front().until <= now; held_.pop_front()) bytes += held_.front().bytes;
  return bytes;
}

}  // namespace tandem::simulator
