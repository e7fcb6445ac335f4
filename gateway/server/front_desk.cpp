#include "gateway/server/front_desk.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "gateway/net/certificate.hpp"
#include "gateway/protocol/messages.hpp"
#include "services/common/file_io.hpp"

namespace tandem::gateway {
namespace {

constexpr const char* kCookie = "__Host-sid";

net::HttpResponse refused(int status, const std::string& why) {
  return {status, "application/json", "{\"error\":\"" + why + "\"}", ""};
}

Secrets real_secrets() {
  return {[] { return net::random_hex(16); }, [] { return net::random_hex(32); }, net::sha256_hex};
}

}  // namespace

FrontDesk::FrontDesk(std::vector<std::string> names, const std::vector<Slot>& slots, std::string sessions_file,
                     const Clock& clock)
    : names_(std::move(names)),
      sessions_file_(std::move(sessions_file)),
      clock_(clock),
      desk_(PairingRules{}, real_secrets()) {
  restore_sessions(slots);
}

/// A line for each session: digest, slot, end [ns].
void FrontDesk::restore_sessions(const std::vector<Slot>& slots) {
  if (!std::filesystem::exists(sessions_file_)) return;
  std::istringstream lines{read_file(sessions_file_)};
  std::string id;
  std::string slot;
  std::int64_t end_ns = 0;
  while (lines >> id >> slot >> end_ns) {
    const auto found = std::find_if(slots.begin(), slots.end(), [&](const Slot& one) { return one.name == slot; });
    if (found != slots.end()) desk_.restore({id, slot, from_stamp_ns(end_ns)}, *found);
  }
}

void FrontDesk::keep_sessions() const {
  std::ostringstream lines;
  for (const auto& session : desk_.kept(clock_.now())) {
    lines << session.id << ' ' << session.slot << ' ' << to_stamp_ns(session.expires) << '\n';
  }
  try {
    write_private_file(sessions_file_, lines.str());
  } catch (const FileError& error) {
    spdlog::warn("sessions not kept, phones must pair again after a restart: {}", error.what());
  }
}

void FrontDesk::open_at(std::uint16_t port) {
  const std::lock_guard lock{mutex_};
  policy_.emplace(names_, port);
}

std::string FrontDesk::issue(const Slot& slot) {
  const std::lock_guard lock{mutex_};
  return desk_.issue(slot, clock_.now());
}

bool FrontDesk::has_token(const Slot& slot, Duration margin) const {
  const std::lock_guard lock{mutex_};
  return desk_.has_token(slot.name, clock_.now(), margin);
}

Slot FrontDesk::slot_of(const std::string& session) const {
  const std::lock_guard lock{mutex_};
  const auto found = admitted_.find(session);
  return found == admitted_.end() ? Slot{} : found->second;
}

std::vector<std::string> FrontDesk::take_ended() {
  const std::lock_guard lock{mutex_};
  auto ended = desk_.take_ended();
  for (const auto& id : ended) admitted_.erase(id);
  return ended;
}

std::optional<net::HttpResponse> FrontDesk::refusal(const net::HttpRequest& request) {
  const std::lock_guard lock{mutex_};
  if (policy_ && policy_->is_our_host(request.host)) return std::nullopt;
  spdlog::warn("request refused: host={} address={}", request.host.substr(0, 80), request.remote_address);
  return refused(403, "this is not a name of the gateway");
}

net::HttpResponse FrontDesk::post(const net::HttpRequest& request) {
  const std::lock_guard lock{mutex_};
  if (request.target != "/api/pair") return refused(404, "there is no such page");
  if (!policy_->is_our_origin(request.origin, request.host)) return refused(403, "from another page");
  if (request.content_type.rfind("application/json", 0) != 0) return refused(415, "JSON only");
  if (request.body.size() > 1024) return refused(413, "too large");
  const auto token = protocol::parse_pairing_request(request.body);
  if (!token) return refused(400, "not a pairing request");
  const auto outcome = desk_.redeem(*token, request.remote_address, clock_.now());
  if (!outcome.paired) {
    const bool locked = outcome.refusal == PairingDesk::Refusal::Locked;
    spdlog::warn("pairing refused: address={} why={}", request.remote_address, locked ? "locked out" : "wrong token");
    return locked ? refused(429, "too many wrong tries, wait a minute") : refused(403, "used, expired or wrong link");
  }
  keep_sessions();
  const auto& slot = outcome.paired->slot;
  spdlog::info("phone paired: slot={} agent={} address={}", slot.name, slot.agent, request.remote_address);
  return {200, "application/json", "{\"role\":\"" + std::string{protocol::name_of(slot.role)} + "\"}",
          std::string{kCookie} + "=" + outcome.paired->session +
              "; Path=/; Secure; HttpOnly; SameSite=Strict; Max-Age=28800"};
}

net::Admission FrontDesk::admit(const net::HttpRequest& request) {
  const std::lock_guard lock{mutex_};
  if (!policy_->is_our_origin(request.origin, request.host)) return {403, ""};
  const auto session = desk_.session_of(cookie_value(request.cookie, kCookie), clock_.now());
  if (!session) return {401, ""};
  admitted_[session->id] = session->slot;
  return {101, session->id};
}

}  // namespace tandem::gateway
