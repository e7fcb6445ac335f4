#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gateway/protocol/messages.hpp"
#include "services/common/time.hpp"

namespace tandem::gateway {

/// The numbers of docs/phone.md.
struct PairingRules {
  Duration token_life = from_seconds(300.0);
  Duration session_life = from_seconds(8 * 3600.0);
  int failures_per_minute = 5;  ///< of one address; then it is locked out
  Duration lock = from_seconds(60.0);
};

/// Whose phone it is and what it may do. A slot ("participant", "observer") holds one phone at a time if `exclusive`.
struct Slot {
  std::string name;
  protocol::UserRole role = protocol::UserRole::Observer;
  std::string agent;  ///< empty for those who only look
  bool exclusive = false;

  friend bool operator==(const Slot&, const Slot&) = default;
};

/// Where secrets come from; handed in, so that tests know them.
struct Secrets {
  std::function<std::string()> new_token;    ///< 128 bits
  std::function<std::string()> new_session;  ///< 256 bits
  std::function<std::string(const std::string&)> digest;
};

/// Gives one-time tokens, trades them for sessions, and keeps only digests of both.
class PairingDesk {
 public:
  PairingDesk(PairingRules rules, Secrets secrets) : rules_(rules), secrets_(std::move(secrets)) {}

  /// A new token for `slot`; the slot's earlier one is void from now on.
  [[nodiscard]] std::string issue(const Slot& slot, Time now);
  /// True while the slot's token can still be used, and will for another `margin`.
  [[nodiscard]] bool has_token(const std::string& slot, Time now, Duration margin = Duration{0}) const;

  enum class Refusal { WrongToken, Locked };
  struct Paired {
    std::string session;  ///< the secret for the cookie
    Slot slot;
  };
  struct Outcome {
    std::optional<Paired> paired;
    Refusal refusal = Refusal::WrongToken;
  };
  /// Trades `token` for a session. An address that guesses wrong too often is locked out for a while, whatever it
  /// brings. A phone that takes an exclusive slot ends the session of the one before.
  [[nodiscard]] Outcome redeem(const std::string& token, const std::string& address, Time now);

  struct Session {
    std::string id;  ///< digest of the secret: safe to keep and to log
    Slot slot;
  };
  [[nodiscard]] std::optional<Session> session_of(const std::string& secret, Time now) const;
  /// The open sessions, for a gateway that is started again: what is kept of them opens nothing by itself.
  struct Kept {
    std::string id;
    std::string slot;
    Time expires;

    friend bool operator==(const Kept&, const Kept&) = default;
  };
  [[nodiscard]] std::vector<Kept> kept(Time now) const;
  /// Opens a session of an earlier desk again, in today's `slot` of its name.
  void restore(const Kept& session, const Slot& slot);
  /// Ids of the sessions that were ended by another phone since the last call.
  [[nodiscard]] std::vector<std::string> take_ended();

 private:
  struct Token {
    std::string digest;
    Slot slot;
    Time expires;
  };
  struct Open {
    Slot slot;
    Time expires;
  };
  struct Failures {
    std::vector<Time> at;
    Time locked_until{};
  };
  void note_failure(const std::string& address, Time now);

  PairingRules rules_;
  Secrets secrets_;
  std::map<std::string, Token> tokens_;       ///< by slot
  std::map<std::string, Open> sessions_;      ///< by digest
  std::map<std::string, Failures> failures_;  ///< by address
  std::vector<std::string> ended_;
};

}  // namespace tandem::gateway
