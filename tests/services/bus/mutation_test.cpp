// X1: whatever bytes a peer sends as a sample, they are dropped or they are a message; nothing crashes.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>

#include "services/bus/payload_type.hpp"
#include "services/common/random.hpp"

namespace tandem::bus {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// A valid payload of every topic: tests/idl/golden_bytes.txt, `topic hex` a line.
std::map<std::string, Bytes> golden_payloads() {
  std::ifstream stream{TANDEM_SOURCE_DIR "/tests/idl/golden_bytes.txt"};
  std::map<std::string, Bytes> all;
  std::string topic;
  std::string hex;
  while (stream >> topic >> hex) {
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
      all[topic].push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
    }
  }
  return all;
}

/// Mutations in all: two seconds of a core; more with TANDEM_MUTATIONS.
std::size_t mutations() {
  const char* wanted = std::getenv("TANDEM_MUTATIONS");
  return wanted != nullptr ? std::stoul(wanted) : 1'000'000;
}

std::size_t below(Rng& rng, std::size_t bound) {
  return static_cast<std::size_t>(rng.bits()) % bound;
}

/// Changes one to four places: a bit, a byte, a length beyond all bounds, a cut, a doubled or a lost piece.
Bytes mutated(Bytes bytes, Rng& rng) {
  static constexpr std::uint32_t kLengths[] = {0, 1, 0x7F, 0x1000'0000, 0x7FFF'FFFF, 0x8000'0000, 0xFFFF'FFFF};
  for (std::size_t changes = 1 + below(rng, 4); changes > 0 && !bytes.empty(); --changes) {
    const std::size_t at = below(rng, bytes.size());
    const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    switch (below(rng, 6)) {
      case 0:
        bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ (1U << below(rng, 8)));
        break;
      case 1:
        bytes[at] = static_cast<std::uint8_t>(rng.bits());
        break;
      case 2: {
        const std::uint32_t length = kLengths[below(rng, std::size(kLengths))];
        for (std::size_t i = 0; i < 4 && at / 4 * 4 + i < bytes.size(); ++i) {
          bytes[at / 4 * 4 + i] = static_cast<std::uint8_t>(length >> (8 * i));
        }
        break;
      }
      case 3:
        bytes.resize(at);
        break;
      case 4:
        bytes.insert(from, bytes.begin(), from);
        break;
      default:
        bytes.erase(from, from + static_cast<std::ptrdiff_t>(std::min<std::size_t>(bytes.size() - at, 4)));
    }
  }
  return bytes;
}

TEST(Mutation, X1NoMutationOfAnyMessageCrashesAndWhatIsNoMessageIsDropped) {
  const auto payloads = golden_payloads();
  const std::size_t each = mutations() / all_topics().size() + 1;
  std::size_t dropped = 0;
  std::size_t taken = 0;
  for (const TopicInfo& topic : all_topics()) {
    const PayloadType type{topic};
    const Bytes& valid = payloads.at(std::string{topic.name});
    ASSERT_EQ(type.problem_of(valid), "") << topic.name;
    Rng rng{7};
    for (std::size_t i = 0; i < each; ++i) {
      const Bytes payload = mutated(valid, rng);
      const bool is_message = type.is_well_formed(payload);
      // Whatever is let in has a key, so that Fast DDS finds its instance.
      EXPECT_TRUE(!is_message || type.key_of(payload)) << topic.name << ", seed 7, mutation " << i;
      ++(is_message ? taken : dropped);
    }
  }
  EXPECT_EQ(taken + dropped, each * all_topics().size());
  EXPECT_GT(dropped, taken / 10);
  RecordProperty("dropped", static_cast<int>(dropped));
  RecordProperty("taken", static_cast<int>(taken));
}

TEST(Mutation, X1ANaNInAnyNumberIsNamed) {
  const auto payloads = golden_payloads();
  constexpr std::uint8_t kNaN[] = {0, 0, 0, 0, 0, 0, 0xF8, 0x7F};  // of a double, little-endian
  // A velocity is judged by the safety gate, which counts what is nonsense.
  const std::pair<TopicInfo, std::size_t> numbers[] = {
      {info_of(topic::kOdometry), 3 + 3 + 9},  // pose, velocity, covariance
      {info_of(topic::kClock), 1},             // its rate
      {info_of(topic::kVelocityCommand), 0},
  };
  for (const auto& [topic, count] : numbers) {
    const PayloadType type{topic};
    const Bytes& valid = payloads.at(std::string{topic.name});
    std::size_t named = 0;
    for (std::size_t at = 4; at + sizeof(kNaN) <= valid.size(); at += 4) {
      Bytes payload = valid;
      std::copy(std::begin(kNaN), std::end(kNaN), payload.begin() + static_cast<std::ptrdiff_t>(at));
      if (type.problem_of(payload) == "a number is NaN") ++named;
    }
    EXPECT_EQ(named, count) << topic.name;
  }
}

TEST(Mutation, ABeamThatSawNothingIsNoFaultOfTheScan) {
  msg::LaserScan scan;
  scan.ranges_m({1.0F, std::numeric_limits<float>::quiet_NaN()});
  EXPECT_FALSE(holds_nan(scan));
  scan.angle_min_rad(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(holds_nan(scan));
}

}  // namespace
}  // namespace tandem::bus
