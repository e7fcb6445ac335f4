#include "services/recorder/core/idl_types.hpp"

#include <gtest/gtest.h>

#include "services/recorder/core/schemas.hpp"

namespace tandem::idl {
namespace {

TEST(IdlTypes, ModulesNameWhatIsInThem) {
  const auto types = parse("module a { module b { struct C { long d; }; }; struct E { b::C f; }; };");
  ASSERT_TRUE(types);
  EXPECT_EQ(types->structs.at("a::b::C").at(0).name, "d");
  EXPECT_EQ(types->structs.at("a::E").at(0).type.name, "a::b::C");
}

TEST(IdlTypes, KnowsSequencesArraysTypedefsAndEnums) {
  const auto types = parse(R"(
    enum Colour { RED, GREEN };
    typedef double Covariance[9];
    @final struct S {
      @key string<8> name;
      unsigned long long stamp_ns;
      sequence<float, 4> ranges;
      Covariance covariance;
      Colour colour;
      sequence<Colour> colours;
    };)");
  ASSERT_TRUE(types);
  EXPECT_EQ(types->enumerators.at("Colour"), (std::vector<std::string>{"RED", "GREEN"}));
  const auto& fields = types->structs.at("S");
  EXPECT_EQ(fields[0].type.kind, Kind::String);
  EXPECT_EQ(fields[1].type.kind, Kind::Uint64);
  EXPECT_TRUE(fields[2].type.is_sequence);
  EXPECT_EQ(fields[3].type.kind, Kind::Double);
  EXPECT_EQ(fields[3].type.array_size, 9U);
  EXPECT_EQ(fields[4].type.kind, Kind::Enum);
  EXPECT_TRUE(fields[5].type.is_sequence);
}

TEST(IdlTypes, TheUnitIsWhatTheCommentBehindAFieldBeginsWith) {
  const auto types =
      parse("struct P { double x;  // [m]\n double heading; // [rad], counter-clockwise\n double n; // many [m]\n };");
  ASSERT_TRUE(types);
  EXPECT_EQ(types->structs.at("P")[0].unit, "[m]");
  EXPECT_EQ(types->structs.at("P")[1].unit, "[rad]");
  EXPECT_EQ(types->structs.at("P")[2].unit, "");
}

TEST(IdlTypes, WhatIsNotUnderstoodIsNone) {
  EXPECT_FALSE(parse("struct A { union_of_things b; };"));
  EXPECT_FALSE(parse("union U switch (long) { case 1: long a; };"));
  EXPECT_FALSE(parse("struct A { long a"));
  EXPECT_FALSE(parse("struct A { sequence<sequence<long>> a; };"));
}

TEST(IdlTypes, UnderstandsTheContractItself) {
  for (const char* name : {"Odometry", "LaserScan", "RobotPose", "TeamPlan", "HumanMessage", "LinkStatus"}) {
    const std::string type = std::string{"tandem::msg::"} + name;
    const auto types = parse(recorder::idl_of(type));
    ASSERT_TRUE(types) << name;
    EXPECT_TRUE(types->structs.contains(type)) << name;
  }
}

}  // namespace
}  // namespace tandem::idl
