#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "gateway/net/https_server.hpp"
#include "gateway/server/core/host_policy.hpp"
#include "gateway/server/core/pairing_desk.hpp"
#include "services/common/clock.hpp"

namespace tandem::gateway {

/// Asks the pairing desk for every request of the HTTPS server. Guards it: the server has a thread of its own.
class FrontDesk final : public net::Gatekeeper {
 public:
  /// `clock` is the machine's, not the mission's: tokens expire in a replay too. Phones of `slots` that an earlier
  /// gateway let in are let in again, by what it left in `sessions_file`; a damaged one is as good as none.
  FrontDesk(std::vector<std::string> names, const std::vector<Slot>& slots, std::string sessions_file,
            const Clock& clock);

  /// The port the server got; before that nobody is let in.
  void open_at(std::uint16_t port);
  /// A new token for `slot`.
  [[nodiscard]] std::string issue(const Slot& slot);
  [[nodiscard]] bool has_token(const Slot& slot, Duration margin) const;
  /// The slot of an admitted session.
  [[nodiscard]] Slot slot_of(const std::string& session) const;
  /// Sessions another phone has taken over since the last call.
  [[nodiscard]] std::vector<std::string> take_ended();

  std::optional<net::HttpResponse> refusal(const net::HttpRequest& request) override;
  net::HttpResponse post(const net::HttpRequest& request) override;
  net::Admission admit(const net::HttpRequest& request) override;

 private:
  void restore_sessions(const std::vector<Slot>& slots);
  void keep_sessions() const;

  std::vector<std::string> names_;
  std::string sessions_file_;
  const Clock& clock_;
  mutable std::mutex mutex_;  ///< guards what follows
  std::optional<HostPolicy> policy_;
  PairingDesk desk_;
  std::map<std::string, Slot> admitted_;  ///< by session id
};

}  // namespace tandem::gateway
