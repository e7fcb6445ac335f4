// What a reader of a State is told when the writer goes, and when it comes back.
#include <gtest/gtest.h>

#include <optional>

#include "services/bus/bus.hpp"
#include "tests/support/domain_lease.hpp"

namespace tandem::bus {
namespace {

using std::chrono::seconds;

class WriterLoss : public ::testing::Test {
 protected:
  [[nodiscard]] DomainOptions options(const std::string& name) const {
    DomainOptions options;
    options.domain = domain_[0];
    options.participant = name;
    return options;
  }
  [[nodiscard]] static msg::BaseStatus status(double battery_v) {
    msg::BaseStatus status;
    status.robot("robot1");
    status.battery_v(battery_v);
    return status;
  }
  /// Waits for a sample with this content, with or without a writer.
  bool is_known(double battery_v, bool writer_alive) {
    return wait_until(receiver_, seconds{10}, [&] {
      const auto newest = reader_.newest();
      return newest && newest->message.battery_v() == battery_v && newest->writer_alive == writer_alive;
    });
  }

  test::DomainLease domain_{1};
  Bus receiver_{options("receiver")};
  Latest<msg::BaseStatus, msg::BaseStatusPubSubType> reader_{receiver_.latest(topic::kBaseStatus)};
};

TEST_F(WriterLoss, AStateWhoseWriterIsGoneIsKeptAndMarked) {
  std::optional<Bus> sender{options("sender")};
  {
    auto writer = sender->writer(topic::kBaseStatus);
    writer.write(status(12.0));
    ASSERT_TRUE(is_known(12.0, true));
  }
  EXPECT_TRUE(is_known(12.0, false));
  EXPECT_EQ(reader_.each().size(), 1U);

  auto another = sender->writer(topic::kBaseStatus);
  another.write(status(11.0));
  EXPECT_TRUE(is_known(11.0, true));
}

TEST_F(WriterLoss, AnInstanceThatAnotherStillWritesIsNotMarked) {
  Bus sender{options("sender")};
  auto stays = sender.writer(topic::kBaseStatus);
  stays.write(status(12.0));
  ASSERT_TRUE(is_known(12.0, true));
  {
    auto goes = sender.writer(topic::kBaseStatus);
    goes.write(status(11.0));
    ASSERT_TRUE(is_known(11.0, true));
  }
  ASSERT_TRUE(wait_until(receiver_, seconds{10}, [&] { return reader_.matched_writers() == 1; }));
  EXPECT_TRUE(reader_.newest()->writer_alive);
}

TEST_F(WriterLoss, AWriterCanWithdrawAnInstanceAndRenewIt) {
  Bus sender{options("sender")};
  auto writer = sender.writer(topic::kBaseStatus);
  writer.write(status(12.0));
  ASSERT_TRUE(is_known(12.0, true));
  const auto key = key_of<msg::BaseStatusPubSubType>(status(0.0));

  EXPECT_TRUE(writer.raw().withdraw(key));
  EXPECT_TRUE(is_known(12.0, false));
  EXPECT_TRUE(writer.raw().renew(key));
  EXPECT_TRUE(is_known(12.0, true));
}

TEST_F(WriterLoss, WhatWasWithdrawnCanBeEnded) {
  Bus sender{options("sender")};
  auto writer = sender.writer(topic::kBaseStatus);
  writer.write(status(12.0));
  ASSERT_TRUE(is_known(12.0, true));
  const auto key = key_of<msg::BaseStatusPubSubType>(status(0.0));
  EXPECT_TRUE(writer.raw().withdraw(key));
  ASSERT_TRUE(is_known(12.0, false));
  EXPECT_TRUE(writer.raw().dispose(key));
  EXPECT_TRUE(wait_until(receiver_, seconds{10}, [&] { return !reader_.newest(); }));
}

TEST_F(WriterLoss, WhatWasNeverWrittenCannotBeRenewed) {
  Bus sender{options("sender")};
  auto writer = sender.writer(topic::kBaseStatus);
  EXPECT_FALSE(writer.raw().renew(key_of<msg::BaseStatusPubSubType>(status(0.0))));
}

}  // namespace
}  // namespace tandem::bus
