#include "services/planner/remote/named_planner.hpp"

#include <gtest/gtest.h>

#include "services/common/config.hpp"

namespace tandem {
namespace {

TEST(NamedPlanner, ExecIsAnotherProgram) {
  EXPECT_TRUE(is_other_program("exec:cat"));
  EXPECT_FALSE(is_other_program("tandem:eligible=6"));
  EXPECT_NE(named_planner("exec:cat", 0.2), nullptr);
}

TEST(NamedPlanner, OthersAreThoseOfTheRegistry) {
  EXPECT_NE(named_planner("tandem:eligible=6", 0.2), nullptr);
  EXPECT_THROW((void)named_planner("nobody", 0.2), ConfigError);
}

}  // namespace
}  // namespace tandem
