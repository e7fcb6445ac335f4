#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include "idl/topics.hpp"
#include "services/bus/codec.hpp"
#include "tests/idl/samples.hpp"

namespace tandem::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// One topic, its type forgotten.
struct Case {
  std::string topic;
  Bytes bytes;              ///< of the filled sample
  bool comes_back = false;  ///< decoding gives the sample
  std::function<bool(const Bytes&)> decodes;
};

template <class PubSubType>
Case case_of(const Topic<PubSubType>& topic) {
  const auto sample = filled<typename PubSubType::type>();
  const Bytes bytes = bus::encode<PubSubType>(sample);
  const auto decoded = bus::decode<PubSubType>(bytes);
  return {std::string{topic.name}, bytes, decoded && *decoded == sample,
          [](const Bytes& other) { return bus::decode<PubSubType>(other).has_value(); }};
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all{case_of(topic::kOdometry),       case_of(topic::kBaseStatus),
                                     case_of(topic::kSonar),          case_of(topic::kVelocityCommand),
                                     case_of(topic::kStopRequest),    case_of(topic::kResumeRequest),
                                     case_of(topic::kScan),           case_of(topic::kCameraImage),
                                     case_of(topic::kDetection),      case_of(topic::kTeammates),
                                     case_of(topic::kPeople),         case_of(topic::kMap),
                                     case_of(topic::kMapHolding),     case_of(topic::kCompressedMap),
                                     case_of(topic::kRobotPose),      case_of(topic::kPoseHint),
                                     case_of(topic::kTeamPlan),       case_of(topic::kPlannerStatus),
                                     case_of(topic::kPlanExecution),  case_of(topic::kInform),
                                     case_of(topic::kBelief),         case_of(topic::kRewardSource),
                                     case_of(topic::kSourceRelation), case_of(topic::kSourceEdit),
                                     case_of(topic::kBeliefEdit),     case_of(topic::kHumanMessage),
                                     case_of(topic::kMessageReceipt), case_of(topic::kSession),
                                     case_of(topic::kReminder),       case_of(topic::kQuestionnaireAnswer),
                                     case_of(topic::kLinkStatus),     case_of(topic::kLinkHeartbeat),
                                     case_of(topic::kServiceHealth),  case_of(topic::kClock),
                                     case_of(topic::kGroundTruth)};
  return all;
}

std::string hex(const Bytes& bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) {
    for (const int digit : {byte >> 4, byte & 15}) text += "0123456789abcdef"[digit];
  }
  return text;
}

/// tests/idl/golden_bytes.txt: `topic hex` a line.
std::map<std::string, std::string> golden() {
  std::ifstream stream{TANDEM_SOURCE_DIR "/tests/idl/golden_bytes.txt"};
  std::map<std::string, std::string> all;
  std::string topic;
  std::string bytes;
  while (stream >> topic >> bytes) all[topic] = bytes;
  return all;
}

TEST(Wire, EveryTopicOfTheTableIsTested) {
  std::set<std::string> tested;
  for (const Case& one : cases()) tested.insert(one.topic);
  for (const TopicInfo& topic : all_topics()) EXPECT_TRUE(tested.contains(std::string{topic.name})) << topic.name;
  EXPECT_EQ(tested.size(), all_topics().size());
}

TEST(Wire, EveryMessageHasItsGoldenBytes) {
  const auto expected = golden();
  EXPECT_EQ(expected.size(), cases().size());
  for (const Case& one : cases()) {
    const auto line = expected.find(one.topic);
    EXPECT_EQ(line == expected.end() ? "" : line->second, hex(one.bytes))
        << "the wire format changed: old recordings and other versions no longer understand " << one.topic;
  }
}

TEST(Wire, EveryMessageComesBackAsItWas) {
  for (const Case& one : cases()) EXPECT_TRUE(one.comes_back) << one.topic;
}

TEST(Wire, AClockIsItsThreeFieldsLittleEndian) {
  msg::Clock clock;
  clock.stamp_ns(1);
  clock.rate(1.0);
  clock.epoch(2);
  EXPECT_EQ(hex(bus::encode<msg::ClockPubSubType>(clock)),
            "00010000"          // CDR, little-endian
            "0100000000000000"  // stamp_ns
            "000000000000f03f"  // rate
            "02000000");        // epoch
}

TEST(Wire, UnknownCdrEncapsulationIsNoMessageAndNoCrash) {
  for (const Case& one : cases()) {
    for (const int id : {0x04, 0x07, 0x42, 0xff}) {
      Bytes bytes = one.bytes;
      bytes[1] = static_cast<std::uint8_t>(id);
      bytes[0] = id == 0x42 ? 0x42 : 0x00;
      EXPECT_FALSE(one.decodes(bytes)) << one.topic << ", encapsulation " << id;
    }
  }
}

TEST(Wire, AMessageCutShortAnywhereIsNoMessage) {
  for (const Case& one : cases()) {
    for (std::size_t length = 0; length < one.bytes.size(); ++length) {
      EXPECT_FALSE(one.decodes({one.bytes.begin(), one.bytes.begin() + static_cast<std::ptrdiff_t>(length)}))
          << one.topic << " cut at byte " << length;
    }
  }
}

TEST(Wire, ALengthBeyondTheMessageIsRefused) {
  for (const Case& one : cases()) {
    for (std::size_t at = 4; at + 4 <= one.bytes.size(); at += 4) {
      Bytes bytes = one.bytes;
      std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), 4, std::uint8_t{0x7f});
      (void)one.decodes(bytes);  // whatever it was: no crash, no huge allocation
    }
  }
}

}  // namespace
}  // namespace tandem::test
