#include "services/relay/core/instance_ledger.hpp"

namespace tandem {

std::vector<InstanceLedger::Key> InstanceLedger::living() const {
  std::vector<Key> keys;
  for (const auto& [key, round] : round_of_) keys.push_back(key);
  return keys;
}

std::vector<InstanceLedger::Key> InstanceLedger::take_missing() {
  std::vector<Key> missing;
  for (const auto& [key, round] : round_of_) {
    if (round != round_) missing.push_back(key);
  }
  for (const auto& key : missing) round_of_.erase(key);
  return missing;
}

}  // namespace tandem
