#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gateway/protocol/messages.hpp"

namespace tandem::gateway {

/// Remembers which commands of each phone have arrived, so that each is applied exactly once however often it is sent,
/// and up to where their fate is known, so that the phone keeps all others: they would be lost with this process.
class CommandLedger {
 public:
  enum class Arrival {
    New,        ///< the next one: to be applied
    Duplicate,  ///< known already: only acknowledged again
    Gap,        ///< one before it is missing: not accepted, the phone repeats from there
  };

  /// Notes the arrival of command `sequence` of `client`. The first command of a client that is not known may have any
  /// number: the gateway has been restarted, and the fate of what came before is known to the phone.
  [[nodiscard]] Arrival arrive(const std::string& client, std::uint64_t sequence);

  /// The fate of every command up to this one is known.
  [[nodiscard]] std::uint64_t settled_up_to(const std::string& client) const;

  /// Keeps what became of a command, for phones that were away; the newest 64 of each client.
  void settle(const std::string& client, const protocol::Result& result);
  [[nodiscard]] std::vector<protocol::Result> results_of(const std::string& client) const;

 private:
  struct Client {
    std::uint64_t arrived = 0;
    std::uint64_t settled = 0;
    std::set<std::uint64_t> settled_beyond{};  ///< while one before them is not
    std::vector<protocol::Result> results;
    std::uint64_t used = 0;  ///< when, to forget the least recently used
  };
  void forget_the_oldest();

  std::map<std::string, Client> clients_;
  std::uint64_t uses_ = 0;
};

}  // namespace tandem::gateway
