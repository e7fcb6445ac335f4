#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/network/lab/laboratory.hpp"
#include "tests/support/rtps_datagram.hpp"

namespace tandem::test {

/// Somebody on the Wi-Fi who writes RTPS by hand: samples that claim to be of another host's relay.
class Forger {
 public:
  /// Listens on the multicast group of `domain`. Throws std::system_error.
  Forger(const LabHost& at, int domain);
  ~Forger();
  Forger(const Forger&) = delete;
  Forger& operator=(const Forger&) = delete;

  /// Waits for the next announcement from `address`, which is open in any case, and takes the sender's name from it.
  /// False if none comes within three seconds.
  [[nodiscard]] bool overhear(const std::string& address);
  /// Sends `payload` to every port of `address` at which a participant of the domain may be, as the sample `number` of
  /// each writer that the overheard relay may have.
  void forge(const std::string& address, const std::vector<std::uint8_t>& payload, std::int64_t number = 1) const;
  /// The same, as the news that the instance `key` has ended.
  void forge_end(const std::string& address, const std::array<std::uint8_t, 16>& key, std::int64_t number) const;
  /// The same, that the samples `first` to `last` will never come.
  void forge_gap(const std::string& address, std::int64_t first, std::int64_t last) const;

 private:
  void send_as_each_writer(const std::string& address, const std::function<void(RtpsDatagram&)>& say) const;

  int socket_ = -1;
  int domain_;
  std::array<std::uint8_t, 12> prefix_{};  // GUID prefix of the relay that was overheard
};

}  // namespace tandem::test
