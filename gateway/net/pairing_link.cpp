#include "gateway/net/pairing_link.hpp"

#include <algorithm>
#include <charconv>

namespace tandem::net {
namespace {

/// Cuts `text` at the first `mark`; none if it is not there.
std::optional<std::string_view> cut(std::string_view& text, std::string_view mark) {
  const auto at = text.find(mark);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view head = text.substr(0, at);
  text.remove_prefix(at + mark.size());
  return head;
}

bool is_word(std::string_view text) {
  return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_';
  });
}

}  // namespace

std::optional<PairingLink> parse_pairing_link(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const auto first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return std::nullopt;
  text = text.substr(first, text.find_last_not_of(kBlank) - first + 1);

  constexpr std::string_view kScheme = "https://";
  if (text.substr(0, kScheme.size()) != kScheme) return std::nullopt;
  text.remove_prefix(kScheme.size());
  const auto host = cut(text, ":");
  const auto port = cut(text, "/p#t=");
  const auto token = cut(text, "&fp=");
  if (!host || host->empty() || !port || !token || !is_word(*token) || !is_word(text)) return std::nullopt;

  PairingLink link{.host = std::string{*host}, .token = std::string{*token}, .fingerprint = std::string{text}};
  const auto [end, error] = std::from_chars(port->data(), port->data() + port->size(), link.port);
  if (error != std::errc{} || end != port->data() + port->size() || link.port == 0) return std::nullopt;
  return link;
}

std::string to_string(const PairingLink& link) {
  return "https://" + link.host + ":" + std::to_string(link.port) + "/p#t=" + link.token + "&fp=" + link.fingerprint;
}

}  // namespace tandem::net
