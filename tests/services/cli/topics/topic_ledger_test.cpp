#include "services/cli/topics/topic_ledger.hpp"

#include <gtest/gtest.h>

namespace tandem::cli {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr bus::EndpointId kBase{1};
constexpr bus::EndpointId kRelay{2};

bus::Endpoint endpoint(const bus::EndpointId& id, const std::string& participant, bus::Endpoint::Kind kind) {
  bus::Endpoint made;
  made.id = id;
  made.kind = kind;
  made.topic = "odometry";
  made.participant = participant;
  return made;
}

class TopicLedgerTest : public ::testing::Test {
 protected:
  /// Ten samples a second from `first` on, the sequence numbers in `numbers`.
  void hear(const std::vector<std::uint64_t>& numbers, bool latched = false) {
    for (const auto number : numbers) {
      now_ += milliseconds{100};
      ledger_.heard({"odometry", kBase, number, now_, latched});
    }
  }
  [[nodiscard]] WriterView writer(const std::vector<bus::MalformedCount>& malformed = {}) {
    return ledger_.view({"odometry"}, endpoints_, malformed, now_).at(0).writers.at(0);
  }

  TopicLedger ledger_;
  std::vector<bus::Endpoint> endpoints_{endpoint(kBase, "base@robot1", bus::Endpoint::Kind::Writer),
                                        endpoint(kRelay, "relay@robot1", bus::Endpoint::Kind::Reader)};
  Time now_ = Time{} + seconds{100};
};

TEST_F(TopicLedgerTest, NamesWritersAndReadersByHostAndService) {
  endpoints_.push_back(endpoint({4}, "relay@robot1", bus::Endpoint::Kind::Reader));  // it reads twice
  const auto views = ledger_.view({"odometry", "scan"}, endpoints_, {}, now_);
  ASSERT_EQ(views.size(), 2U);
  ASSERT_EQ(views[0].writers.size(), 1U);
  EXPECT_EQ(views[0].writers[0].service, "base");
  EXPECT_EQ(views[0].writers[0].host, "robot1");
  EXPECT_FALSE(views[0].writers[0].age_s);
  ASSERT_EQ(views[0].readers.size(), 1U);
  EXPECT_EQ(views[0].readers[0].service, "relay");
  EXPECT_TRUE(views[1].writers.empty());
}

TEST_F(TopicLedgerTest, CountsWhatNeverCame) {
  hear({1, 2, 3, 5, 6, 8, 9, 10});
  EXPECT_EQ(writer().samples, 8U);
  EXPECT_EQ(writer().lost, 2U);
  EXPECT_DOUBLE_EQ(writer().loss(), 0.2);
}

TEST_F(TopicLedgerTest, WhatWasSaidBeforeWeCameIsNotLost) {
  hear({1000, 1001});
  EXPECT_EQ(writer().lost, 0U);
}

TEST_F(TopicLedgerTest, ThePastOfAStateHasGapsThatAreNoLoss) {
  hear({3, 17, 40}, true);  // newest of three instances
  EXPECT_EQ(writer().lost, 0U);
  now_ += seconds{1};
  hear({41, 43}, true);
  EXPECT_EQ(writer().lost, 1U);
}

TEST_F(TopicLedgerTest, AMalformedSampleDidArrive) {
  hear({1, 2, 4});
  bus::MalformedCount bad;
  bad.topic = "odometry";
  bad.writer = kBase;
  bad.count = 1;
  EXPECT_EQ(writer({bad}).lost, 0U);
  EXPECT_EQ(writer({bad}).malformed, 1U);
}

TEST_F(TopicLedgerTest, TheRateIsOfTheLastFiveSeconds) {
  std::vector<std::uint64_t> numbers(100);
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = i + 1;
  hear(numbers);
  EXPECT_NEAR(writer().rate_hz, 10.0, 0.3);
  now_ += seconds{6};
  EXPECT_EQ(writer().rate_hz, 0.0);
  EXPECT_DOUBLE_EQ(*writer().age_s, 6.0);
}

TEST_F(TopicLedgerTest, AWriterThatVanishedIsShownForAWhile) {
  hear({1, 2, 3});
  EXPECT_TRUE(writer().alive);
  endpoints_.clear();
  EXPECT_FALSE(writer().alive);
  now_ += seconds{31};
  EXPECT_TRUE(ledger_.view({"odometry"}, endpoints_, {}, now_)[0].writers.empty());
}

TEST_F(TopicLedgerTest, WeOurselvesAreNotShown) {
  endpoints_[1].own = true;
  EXPECT_TRUE(ledger_.view({"odometry"}, endpoints_, {}, now_)[0].readers.empty());
}

TEST_F(TopicLedgerTest, ATopicThatIsNoneOfOursIsShownLast) {
  endpoints_.push_back(endpoint({3}, "stranger", bus::Endpoint::Kind::Writer));
  endpoints_.back().topic = "chatter";
  const auto views = ledger_.view({"odometry"}, endpoints_, {}, now_);
  ASSERT_EQ(views.size(), 2U);
  EXPECT_EQ(views[1].topic, "chatter");
  EXPECT_EQ(views[1].writers[0].service, "stranger");
  EXPECT_EQ(views[1].writers[0].host, "?");
}

}  // namespace
}  // namespace tandem::cli
