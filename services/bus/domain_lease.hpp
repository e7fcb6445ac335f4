#pragma once

#include <cstddef>
#include <vector>

namespace tandem::bus {

/// DDS domains that nobody else on this machine takes through here while this object lives, so that demos and tests
/// run side by side. Labs give their domains in site.toml.
class DomainLease {
 public:
  /// `count` free domains from `first` on. Throws std::runtime_error when there are fewer.
  explicit DomainLease(int count, int first = kFirstForTests);
  ~DomainLease();
  DomainLease(const DomainLease&) = delete;
  DomainLease& operator=(const DomainLease&) = delete;
  [[nodiscard]] int operator[](std::size_t index) const { return domains_[index]; }

  static constexpr int kFirstForDemos = 10;
  static constexpr int kFirstForTests = 40;

 private:
  std::vector<int> domains_;
  std::vector<int> locks_;
};

}  // namespace tandem::bus
