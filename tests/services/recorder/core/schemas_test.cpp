#include "services/recorder/core/schemas.hpp"

#include <gtest/gtest.h>

#include "idl/topics.hpp"

namespace tandem::recorder {
namespace {

TEST(Schemas, EveryTopicHasTheIdlOfItsTypeWithTheIncludesInlined) {
  for (const TopicInfo& topic : all_topics()) {
    const std::string type = topic.make_type()->getName();
    const std::string_view idl = idl_of(type);
    const std::string name = type.substr(type.rfind(':') + 1);
    EXPECT_NE(idl.find("struct " + name + " {"), std::string_view::npos) << type;
    EXPECT_NE(idl.find("struct Point2"), std::string_view::npos) << type;
    EXPECT_EQ(idl.find("#include"), std::string_view::npos) << type;
  }
}

TEST(Schemas, ATypeThatIsNotOursHasNone) {
  EXPECT_TRUE(idl_of("std_msgs::String").empty());
}

}  // namespace
}  // namespace tandem::recorder
