#include "services/planner/core/planners/planner_options.hpp"

#include <gtest/gtest.h>

#include "services/common/config.hpp"

namespace tandem {
namespace {

TEST(PlannerOptions, GivesWhatIsThereAndTheDefaultElse) {
  PlannerOptions options("paper:nodes=300,weight=0.5");
  EXPECT_EQ(options.name(), "paper");
  EXPECT_EQ(options.whole_number("nodes", 1000), 300);
  EXPECT_DOUBLE_EQ(options.number("weight", 0.1), 0.5);
  EXPECT_DOUBLE_EQ(options.number("discount", 0.8), 0.8);
  EXPECT_NO_THROW(options.refuse_unknown());
}

TEST(PlannerOptions, RefusesWhatNobodyAskedFor) {
  PlannerOptions options("paper:nodes=300,wieght=0.5");
  (void)options.number("nodes", 1000);
  EXPECT_THROW(options.refuse_unknown(), ConfigError);
}

TEST(PlannerOptions, RefusesWhatIsNoNumber) {
  EXPECT_THROW(PlannerOptions("paper:nodes=many"), ConfigError);
  EXPECT_THROW(PlannerOptions("paper:nodes="), ConfigError);
}

}  // namespace
}  // namespace tandem
