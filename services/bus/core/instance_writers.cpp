#include "services/bus/core/instance_writers.hpp"

namespace tandem::bus {

void InstanceWriters::wrote(const Key& key, const Writer& writer) {
  orphans_.erase(key);
  writers_[key].insert(writer);
}

void InstanceWriters::ended(const Key& key) {
  orphans_.erase(key);
  writers_.erase(key);
}

bool InstanceWriters::withdrew(const Key& key, const Writer& writer) {
  const auto known = writers_.find(key);
  if (known == writers_.end()) return false;
  known->second.erase(writer);
  if (!known->second.empty()) return false;
  writers_.erase(known);
  return true;
}

std::vector<InstanceWriters::Key> InstanceWriters::lost(const Writer& writer) {
  std::vector<Key> keys;
  for (const auto& [key, writers] : writers_) {
    if (writers.contains(writer)) keys.push_back(key);
  }
  std::erase_if(keys, [&](const Key& key) { return !withdrew(key, writer); });
  for (const Key& key : keys) orphans_[key] = writer;
  return keys;
}

std::vector<InstanceWriters::Key> InstanceWriters::back(const Writer& writer) {
  std::vector<Key> keys;
  for (const auto& [key, last] : orphans_) {
    if (last == writer) keys.push_back(key);
  }
  for (const Key& key : keys) wrote(key, writer);
  return keys;
}

}  // namespace tandem::bus
