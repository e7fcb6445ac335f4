#include "services/bus/core/endpoint_table.hpp"

#include <gtest/gtest.h>

namespace tandem::bus {
namespace {

Endpoint endpoint(std::uint8_t participant, std::uint8_t entity, Endpoint::Kind kind) {
  Endpoint made;
  made.id[0] = participant;
  made.id[15] = entity;
  made.kind = kind;
  made.topic = "team_plan";
  made.type = "tandem::msg::TeamPlan";
  made.keyed = true;
  made.qos.reliable = true;
  made.qos.durability = 1;
  return made;
}

/// Our reader, as the navigator's.
Endpoint own_reader() {
  Endpoint made = endpoint(1, 1, Endpoint::Kind::Reader);
  made.own = true;
  made.participant = "navigator@robot1";
  return made;
}

class EndpointTableTest : public ::testing::Test {
 protected:
  EndpointTableTest() {
    table_.found(own_reader());
    table_.participant_found({2}, "planner@evil");
  }
  [[nodiscard]] std::vector<PeerFault> faults(Concern concern = Concern::Own) const {
    return misfits(table_.endpoints(), concern);
  }

  EndpointTable table_;
};

TEST_F(EndpointTableTest, EndpointsThatFitAreNoFault) {
  table_.found(endpoint(2, 1, Endpoint::Kind::Writer));
  EXPECT_TRUE(faults().empty());
}

TEST_F(EndpointTableTest, X3AWrongTypeIsNamedWithItsWriter) {
  Endpoint writer = endpoint(2, 1, Endpoint::Kind::Writer);
  writer.type = "other::Plan";
  table_.found(writer);
  ASSERT_EQ(faults().size(), 1U);
  EXPECT_EQ(text_of(faults()[0]),
            "X3: wrong type on team_plan: planner@evil writes other::Plan, ours is tandem::msg::TeamPlan");
}

TEST_F(EndpointTableTest, X3TheSameTypeWithoutItsKeyIsAnother) {
  Endpoint writer = endpoint(2, 1, Endpoint::Kind::Writer);
  writer.keyed = false;
  table_.found(writer);
  ASSERT_EQ(faults().size(), 1U);
  EXPECT_NE(faults()[0].what.find("tandem::msg::TeamPlan without a key, ours is tandem::msg::TeamPlan with a key"),
            std::string::npos);
}

TEST_F(EndpointTableTest, X3EveryPolicyThatDoesNotFitIsNamed) {
  struct Case {
    void (*change)(EndpointQos& offered);
    const char* text;
  };
  const Case cases[] = {
      {[](EndpointQos& qos) { qos.reliable = false; },
       "planner@evil offers best effort, navigator@robot1 asks for reliable"},
      {[](EndpointQos& qos) { qos.durability = 0; }, "offers volatile data, navigator@robot1 asks for transient local"},
      {[](EndpointQos& qos) { qos.exclusive = true; }, "offers exclusive ownership, navigator@robot1 asks for shared"},
  };
  for (const Case& one : cases) {
    Endpoint writer = endpoint(2, 1, Endpoint::Kind::Writer);
    one.change(writer.qos);
    table_.found(writer);
    ASSERT_EQ(faults().size(), 1U) << one.text;
    EXPECT_NE(faults()[0].what.find(one.text), std::string::npos) << faults()[0].what;
  }
}

TEST_F(EndpointTableTest, X3AReaderThatAsksForADeadlineIsNamed) {
  Endpoint writer = endpoint(1, 2, Endpoint::Kind::Writer);
  writer.own = true;
  writer.participant = "planner@laptop1";
  writer.topic = "belief";
  Endpoint reader = endpoint(2, 1, Endpoint::Kind::Reader);
  reader.topic = "belief";
  reader.qos.deadline_ns = 500'000'000;
  table_.found(writer);
  table_.found(reader);
  ASSERT_EQ(faults().size(), 1U);
  EXPECT_EQ(faults()[0].what,
            "incompatible QoS on belief: planner@laptop1 offers deadline none, planner@evil asks for 0.500 s");
}

TEST_F(EndpointTableTest, MoreThanIsAskedForIsEnough) {
  Endpoint writer = endpoint(2, 1, Endpoint::Kind::Writer);
  writer.qos.durability = 3;
  writer.qos.deadline_ns = 1'000;
  table_.found(writer);
  EXPECT_TRUE(faults().empty());
}

TEST_F(EndpointTableTest, TwoOthersAreTheConcernOfWhoeverWatchesAlone) {
  Endpoint writer = endpoint(2, 1, Endpoint::Kind::Writer);
  writer.topic = "belief";
  writer.qos.reliable = false;
  Endpoint reader = endpoint(3, 1, Endpoint::Kind::Reader);
  reader.topic = "belief";
  table_.found(writer);
  table_.found(reader);
  EXPECT_TRUE(faults(Concern::Own).empty());
  EXPECT_EQ(faults(Concern::All).size(), 1U);
}

TEST_F(EndpointTableTest, AParticipantTakesItsEndpointsAlong) {
  Endpoint writer = endpoint(2, 1, Endpoint::Kind::Writer);
  writer.qos.reliable = false;
  table_.found(writer);
  EXPECT_EQ(faults().size(), 1U);
  table_.participant_gone({2});
  EXPECT_TRUE(faults().empty());
  EXPECT_EQ(table_.endpoints().size(), 1U);
}

TEST_F(EndpointTableTest, AChangedQosReplacesTheOldOne) {
  Endpoint writer = endpoint(2, 1, Endpoint::Kind::Writer);
  writer.qos.reliable = false;
  table_.found(writer);
  writer.qos.reliable = true;
  table_.found(writer);
  EXPECT_TRUE(faults().empty());
  table_.gone(writer.id);
  EXPECT_EQ(table_.endpoints().size(), 1U);
}

TEST_F(EndpointTableTest, ANameThatIsUsedTwiceStandsTwice) {
  table_.participant_found({3}, "planner@evil");
  EXPECT_EQ(table_.participants(), (std::vector<std::string>{"planner@evil", "planner@evil"}));
  EXPECT_EQ(table_.participant_of({9}), "somebody");
}

}  // namespace
}  // namespace tandem::bus
