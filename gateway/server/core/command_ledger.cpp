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
    clients_[client] = {.up_to = sequence, .results = {}, .used = ++uses_};
    return Arrival::New;
  }
  Client& known = found->second;
  known.used = ++uses_;
  if (sequence <= known.up_to) return Arrival::Duplicate;
  if (sequence > known.up_to + 1) return Arrival::Gap;
  known.up_to = sequence;
  return Arrival::New;
}

std::uint64_t CommandLedger::up_to(const std::string& client) const {
  const auto found = clients_.find(client);
  return found == clients_.end() ? 0 : found->second.up_to;
}

void CommandLedger::settle(const std::string& client, const protocol::Result& result) {
  const auto found = clients_.find(client);
  if (found == clients_.end()) return;
  auto& results = found->second.results;
  results.push_back(result);
  if (results.size() > kKeptResults) results.erase(results.begin());
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
