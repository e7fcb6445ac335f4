#include "services/common/strict_json.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

namespace tandem {
namespace {

std::string complaint_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

/// What reading `text` with `read` says is wrong.
std::string complaint_about(const std::string& text, const std::function<void(StrictObject&)>& read) {
  const auto json = parse_json(text, "room.json");
  return complaint_of([&] {
    StrictObject object{json, "room.json"};
    read(object);
    object.refuse_unknown_keys();
  });
}

TEST(StrictJson, TextThatIsNoJsonIsNamedByFileAndLine) {
  const auto complaint = complaint_of([] { (void)parse_json("{\n\"a\": }", "room.json"); });
  EXPECT_TRUE(complaint.starts_with("room.json: ")) << complaint;
  EXPECT_NE(complaint.find("line 2, column 6"), std::string::npos) << complaint;
}

TEST(StrictJson, AKeyNobodyAskedForIsRefused) {
  const auto complaint = complaint_about(R"({"seed": 1, "sed": 2})", [](StrictObject& object) {
    EXPECT_EQ(object.whole_number_or("seed", 0, Range{0, 9}), 1);
  });
  EXPECT_TRUE(complaint.starts_with("room.json")) << complaint;
  EXPECT_NE(complaint.find("sed"), std::string::npos) << complaint;
}

TEST(StrictJson, AnAbsentKeyIsItsFallbackOrAnError) {
  EXPECT_EQ(complaint_about("{}",
                            [](StrictObject& object) {
                              EXPECT_DOUBLE_EQ(object.number_or("rate", 2.5, Range{0.0, 9.0}), 2.5);
                              EXPECT_FALSE(object.has("rate"));
                              EXPECT_TRUE(object.objects("people").empty());
                            }),
            "");
  EXPECT_NE(complaint_about("{}", [](StrictObject& object) { (void)object.number("rate", {}); }), "");
}

TEST(StrictJson, WrongTypesAndValuesOutsideTheirRangeAreRefused) {
  const auto number = [](StrictObject& object) { (void)object.number("rate", Range{0.0, 9.0}); };
  EXPECT_EQ(complaint_about(R"({"rate": 9})", number), "");
  EXPECT_NE(complaint_about(R"({"rate": 9.5})", number), "");
  EXPECT_NE(complaint_about(R"({"rate": "fast"})", number), "");
  EXPECT_NE(complaint_about(R"({"p": [1, 2, 3]})", [](StrictObject& object) { (void)object.numbers("p", 2); }), "");
  EXPECT_NE(complaint_about("[]", [](StrictObject&) {}), "");
}

TEST(StrictJson, AnObjectWhoseKeysAreNamesGivesThemAll) {
  EXPECT_EQ(complaint_about(R"({"kitchen": 1, "hall": 2, "comment": "rooms"})",
                            [](StrictObject& object) {
                              EXPECT_EQ(object.names(), (std::vector<std::string>{"hall", "kitchen"}));
                            }),
            "");
  EXPECT_NE(complaint_about(R"({"who": ["a", 1]})", [](StrictObject& object) { (void)object.texts("who"); }), "");
}

}  // namespace
}  // namespace tandem
