#include "tests/support/domain_lease.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace tandem::test {
namespace {

constexpr int kFirst = 40;  // below are the domains of demos and labs
constexpr int kLast = 101;  // above, DDS ports fall into the ephemeral range

}  // namespace

DomainLease::DomainLease(int count) {
  const auto folder = std::filesystem::temp_directory_path();
  // The locks of a dead test are free at once: the kernel drops them with the process.
  for (int domain = kFirst; domain <= kLast && static_cast<int>(domains_.size()) < count; ++domain) {
    const auto file = folder / ("tandem-test-domain-" + std::to_string(domain));
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
  throw std::runtime_error("too few free DDS domains for a test");
}

DomainLease::~DomainLease() {
  for (const int lock : locks_) close(lock);
}

}  // namespace tandem::test
