#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "gateway/protocol/client_messages.hpp"
#include "gateway/protocol/server_messages.hpp"

/// The messages between phone and gateway (subprotocol tandem.v1, JSON text frames). The document of record is
/// tandem.schema.json beside this file; examples/ is read by the tests of both sides. SI units, map frame.
namespace tandem::protocol {

/// Why a text is not a message.
struct Malformed {
  std::string reason;
};

/// Exactly one message, with no unknown, missing or repeated key, no number that is not finite, nesting of at most 8.
[[nodiscard]] std::variant<ClientMessage, Malformed> parse_client_message(std::string_view text);
[[nodiscard]] std::variant<ServerMessage, Malformed> parse_server_message(std::string_view text);

[[nodiscard]] std::string write(const ClientMessage& message);
[[nodiscard]] std::string write(const ServerMessage& message);

/// The token in the body of POST /api/pair, `{"token": "..."}`; none if it is anything else.
[[nodiscard]] std::optional<std::string> parse_pairing_request(std::string_view body);

}  // namespace tandem::protocol
