#include "gateway/protocol/messages.hpp"

#include <gtest/gtest.h>

#include "gateway/protocol/belief_frame.hpp"

namespace tandem::protocol {
namespace {

std::string reason_of(const std::string& text) {
  const auto parsed = parse_client_message(text);
  const auto* malformed = std::get_if<Malformed>(&parsed);
  return malformed == nullptr ? "" : malformed->reason;
}

TEST(ClientMessage, KeepsWhereAndWhenThePersonPressed) {
  const auto parsed = parse_client_message(
      R"({"type":"cmd","client":"abcdefgh","sequence":3,"kind":"my_pose","x":1.5,"y":-2,"age_ms":40})");
  const auto& command = std::get<Command>(std::get<ClientMessage>(parsed));
  EXPECT_EQ(command.sequence, 3u);
  EXPECT_EQ(command.kind, CommandKind::MyPose);
  EXPECT_EQ(command.point_in_map, (Point{1.5, -2.0}));
  EXPECT_FALSE(command.heading);
  EXPECT_DOUBLE_EQ(command.age_ms, 40.0);
}

TEST(ClientMessage, MalformedJsonIsRefusedWithItsPlace) {
  EXPECT_EQ(reason_of("{"), "not JSON at character 2");
  EXPECT_EQ(reason_of(R"({"type":"ping","sent_at_ms":1,"sent_at_ms":1})"), "key 'sent_at_ms' comes twice");
  EXPECT_EQ(reason_of(std::string(10'000, '[')), "nested deeper than 8");
  EXPECT_NE(reason_of("{\"type\":\"\xff\"}"), "");
  EXPECT_NE(reason_of(R"({"type":"ping","sent_at_ms":1e999})"), "");
}

TEST(ServerMessage, ReplacesWhatIsNotUtf8InTexts) {
  const std::string text = write(ServerMessage{Event{"error", "bad \xff byte", {}}});
  EXPECT_TRUE(std::holds_alternative<ServerMessage>(parse_server_message(text)));
}

TEST(PairingRequest, HasOneTokenAndNothingElse) {
  EXPECT_EQ(parse_pairing_request(R"({"token":"abc"})"), "abc");
  EXPECT_FALSE(parse_pairing_request(R"({"token":"abc","role":"operator"})"));
  EXPECT_FALSE(parse_pairing_request(R"({"token":1})"));
  EXPECT_FALSE(parse_pairing_request("token=abc"));
}

TEST(BeliefFrame, HasAHeadOf22BytesThenTheCells) {
  const std::string bytes = write(BeliefGrid{2, 1, 0.5F, -1.0F, 0.0F, 7, {10, 255}});
  ASSERT_EQ(bytes.size(), 24u);
  EXPECT_EQ(bytes[0], 1);
  EXPECT_EQ(bytes[2], 2);
  EXPECT_EQ(bytes[4], 1);
  EXPECT_EQ(bytes.substr(6, 4), std::string("\x00\x00\x00\x3f", 4));  // 0.5
  EXPECT_EQ(bytes[18], 7);
  EXPECT_EQ(static_cast<unsigned char>(bytes[23]), 255);
}

}  // namespace
}  // namespace tandem::protocol
