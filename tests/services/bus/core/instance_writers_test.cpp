#include "services/bus/core/instance_writers.hpp"

#include <gtest/gtest.h>

namespace tandem::bus {
namespace {

using Keys = std::vector<InstanceWriters::Key>;
constexpr InstanceWriters::Key kOne{1};
constexpr InstanceWriters::Key kTwo{2};
constexpr InstanceWriters::Writer kBase{10};
constexpr InstanceWriters::Writer kOther{11};

TEST(InstanceWriters, AnInstanceIsLostWithItsLastWriterAlone) {
  InstanceWriters writers;
  writers.wrote(kOne, kBase);
  writers.wrote(kTwo, kBase);
  writers.wrote(kTwo, kOther);
  EXPECT_EQ(writers.lost(kBase), Keys{kOne});
  EXPECT_EQ(writers.lost(kOther), Keys{kTwo});
  EXPECT_EQ(writers.lost(kOther), Keys{});
}

TEST(InstanceWriters, AWriterThatIsBackBringsItsInstancesBack) {
  InstanceWriters writers;
  writers.wrote(kOne, kBase);
  EXPECT_EQ(writers.lost(kBase), Keys{kOne});
  EXPECT_EQ(writers.back(kOther), Keys{});
  EXPECT_EQ(writers.back(kBase), Keys{kOne});
  EXPECT_EQ(writers.lost(kBase), Keys{kOne});
}

TEST(InstanceWriters, WhatAnotherWroteMeanwhileIsNotBroughtBack) {
  InstanceWriters writers;
  writers.wrote(kOne, kBase);
  std::ignore = writers.lost(kBase);
  writers.wrote(kOne, kOther);
  EXPECT_EQ(writers.back(kBase), Keys{});
}

TEST(InstanceWriters, WhatWasDisposedOfIsNeitherLostNorBroughtBack) {
  InstanceWriters writers;
  writers.wrote(kOne, kBase);
  writers.wrote(kTwo, kBase);
  writers.ended(kOne);
  EXPECT_EQ(writers.lost(kBase), Keys{kTwo});
  writers.ended(kTwo);
  EXPECT_EQ(writers.back(kBase), Keys{});
}

TEST(InstanceWriters, ToWithdrawEndsAnInstanceThatNobodyElseWrites) {
  InstanceWriters writers;
  writers.wrote(kOne, kBase);
  writers.wrote(kOne, kOther);
  EXPECT_FALSE(writers.withdrew(kOne, kBase));
  EXPECT_TRUE(writers.withdrew(kOne, kOther));
  EXPECT_FALSE(writers.withdrew(kOne, kOther));
}

}  // namespace
}  // namespace tandem::bus
