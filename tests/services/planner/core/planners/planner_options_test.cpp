#include "services/planner/core/planners/planner_options.hpp"

#include <gtest/gtest.h>

#include "services/common/config.hpp"

namespace tandem {
namespace {

TEST(PlannerOptions, GivesWhatIsThereAndTheDefaultElse) {
  PlannerOptions options("paper:nodes=300,weight=0.5,printed=1");
  int nodes = 1000;
  double weight = 0.1;
  double discount = 0.8;
  bool printed = false;
  bool tuned = true;
  options.read("nodes", nodes);
  options.read("weight", weight);
  options.read("discount", discount);
  options.read("printed", printed);
  options.read("tuned", tuned);
  EXPECT_EQ(options.name(), "paper");
  EXPECT_EQ(nodes, 300);
  EXPECT_DOUBLE_EQ(weight, 0.5);
  EXPECT_DOUBLE_EQ(discount, 0.8);
  EXPECT_TRUE(printed);
  EXPECT_TRUE(tuned);
  EXPECT_NO_THROW(options.refuse_unknown());
}

TEST(PlannerOptions, RefusesWhatNobodyAskedFor) {
  PlannerOptions options("paper:nodes=300,wieght=0.5");
  int nodes = 1000;
  options.read("nodes", nodes);
  EXPECT_THROW(options.refuse_unknown(), ConfigError);
}

TEST(PlannerOptions, RefusesWhatIsNoNumber) {
  EXPECT_THROW(PlannerOptions("paper:nodes=many"), ConfigError);
  EXPECT_THROW(PlannerOptions("paper:nodes="), ConfigError);
}

}  // namespace
}  // namespace tandem
