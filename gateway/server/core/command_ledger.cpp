#include "gateway/server/core/command_ledger.hpp"

#include <algorithm>

namespace tandem::gateway {
namespace {

constexpr std::size_t kKeptResults = 64;
constexpr std::size_t kKeptClients = 256;

}  // namespace

CommandLedger::Arrival CommandLedger::arrive(const std::string& client, std::uint64_t sequence) {
  const auto found = clients_.find(client);
  if (found == clients_.end()) {
    if (clients_.size() >= kKeptClients) forget_the_oldest();
    clients_[client] = {.arrived = sequence, .settled = sequence - 1, .results = {}, .used = ++uses_};
    return Arrival::New;
  }
  Client& known = found->second;
  known.used = ++uses_;
  if (sequence <= known.arrived) return Arrival::Duplicate;
  if (sequence > known.arrived + 1) return Arrival::Gap;
  known.arrived = sequence;
  return Arrival::New;
}

std::uint64_t CommandLedger::settled_up_to(const std::string& client) const {
  const auto found = clients_.find(client);
  return found == clients_.end() ? 0 : found->second.settled;
}

void CommandLedger::settle(const std::string& client, const protocol::Result& result) {
  const auto found = clients_.find(client);
  if (found == clients_.end()) return;
  auto& [arrived, settled, settled_beyond, results, used] = found->second;
  results.push_back(result);
  if (results.size() > kKeptResults) results.erase(results.begin());
  settled_beyond.insert(result.sequence);
  while (!settled_beyond.empty() && *settled_beyond.begin() <= settled + 1) {
    settled = std::max(settled, *settled_beyond.begin());
    settled_beyond.erase(settled_beyond.begin());
  }
}

std::vector<protocol::Result> CommandLedger::results_of(const std::string& client) const {
  const auto found = clients_.find(client);
  return found == clients_.end() ? std::vector<protocol::Result>{} : found->second.results;
}

void CommandLedger::forget_the_oldest() {
  clients_.erase(std::min_element(clients_.begin(), clients_.end(),
                                  [](const auto& a, const auto& b) { return a.second.used < b.second.used; }));
}

}  // namespace tandem::gateway
