#pragma once

#include <cstddef>
#include <vector>

namespace tandem::test {

/// DDS domains that no other test on this machine uses while this object lives, so that tests can run side by side.
class DomainLease {
 public:
  /// Throws when fewer than `count` are free.
  explicit DomainLease(int count);
  ~DomainLease();
  DomainLease(const DomainLease&) = delete;
  DomainLease& operator=(const DomainLease&) = delete;
  [[nodiscard]] int operator[](std::size_t index) const { return domains_[index]; }

 private:
  std::vector<int> domains_;
  std::vector<int> locks_;
};

}  // namespace tandem::test
