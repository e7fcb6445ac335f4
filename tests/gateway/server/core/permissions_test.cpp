#include "gateway/server/core/permissions.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

namespace tandem::gateway {
namespace {

using protocol::Command;
using protocol::CommandKind;
using protocol::UserRole;

constexpr std::initializer_list<CommandKind> kAll{
    CommandKind::MyPose,   CommandKind::MyGoal,      CommandKind::RobotGoal,      CommandKind::RobotPose,
    CommandKind::Replan,   CommandKind::ClearMyGoal, CommandKind::ClearRobotGoal, CommandKind::Found,
    CommandKind::Stop,     CommandKind::Resume,      CommandKind::SourceEdit,     CommandKind::BeliefEdit,
    CommandKind::Reminder, CommandKind::Layer};

TEST(Permissions, ObserverMayOnlyStop) {
  for (const auto kind : kAll) {
    EXPECT_EQ(!refusal_of(UserRole::Observer, kind, true).has_value(), kind == CommandKind::Stop);
  }
}

TEST(Permissions, ParticipantMayPlaceTheRobotOnlyBeforeTheSearch) {
  for (const auto kind : kAll) {
    EXPECT_FALSE(refusal_of(UserRole::Participant, kind, false));
    EXPECT_EQ(refusal_of(UserRole::Participant, kind, true).has_value(), kind == CommandKind::RobotPose);
  }
}

TEST(Permissions, OperatorMayDoEverythingAtAnyTime) {
  for (const auto kind : kAll) EXPECT_FALSE(refusal_of(UserRole::Operator, kind, true));
}

Command command(CommandKind kind, double age_ms) {
  Command one;
  one.kind = kind;
  one.age_ms = age_ms;
  return one;
}

TEST(Permissions, AnOldPoseIsNotTakenForNow) {
  EXPECT_FALSE(refusal_of(command(CommandKind::MyPose, 3000.0)));
  EXPECT_TRUE(refusal_of(command(CommandKind::MyPose, 3001.0)));
}

TEST(Permissions, AnOldWishIsAskedForAgain) {
  EXPECT_FALSE(refusal_of(command(CommandKind::MyGoal, 15'000.0)));
  EXPECT_TRUE(refusal_of(command(CommandKind::MyGoal, 15'001.0)));
}

TEST(Permissions, StopIsNeverTooOld) {
  EXPECT_FALSE(refusal_of(command(CommandKind::Stop, 1e9)));
}

TEST(Permissions, WhatHappenedOnThePhoneIsRecordedHoweverLate) {
  EXPECT_FALSE(refusal_of(command(CommandKind::Reminder, 1e9)));
  EXPECT_FALSE(refusal_of(command(CommandKind::Layer, 1e9)));
  EXPECT_TRUE(refusal_of(command(CommandKind::SourceEdit, 15'001.0)));
}

TEST(Permissions, ResumeMustHaveBeenHeldForASecond) {
  Command resume = command(CommandKind::Resume, 0.0);
  resume.held_ms = 999.0;
  EXPECT_TRUE(refusal_of(resume));
  resume.held_ms = 1000.0;
  EXPECT_FALSE(refusal_of(resume));
}

}  // namespace
}  // namespace tandem::gateway
