#include "services/bus/domain_lease.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace tandem::bus {
namespace {

constexpr int kLast = 101;  // above, DDS ports fall into the ephemeral range

}  // namespace

DomainLease::DomainLease(int count, int first) {
  const auto folder = std::filesystem::temp_directory_path();
  // The locks of a dead process are free at once: the kernel drops them with it.
  for (int domain = first; domain <= kLast && static_cast<int>(domains_.size()) < count; ++domain) {
    const auto file = folder / ("tandem-domain-" + std::to_string(domain));
    const int lock = open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
    if (lock < 0) continue;
    if (flock(lock, LOCK_EX | LOCK_NB) != 0) {
      close(lock);
      continue;
    }
    domains_.push_back(domain);
    locks_.push_back(lock);
  }
  if (static_cast<int>(domains_.size()) == count) return;
  for (const int lock : locks_) close(lock);
  throw std::runtime_error("too few free DDS domains: end other runs of tandem on this machine");
}

DomainLease::~DomainLease() {
  for (const int lock : locks_) close(lock);
}

}  // namespace tandem::bus
