#include "bench/network/airs.hpp"

#include <stdexcept>

namespace tandem::bench {

test::Conditions conditions_of(const std::string& air) {
  using std::chrono::milliseconds;
  test::Conditions conditions;
  if (air.starts_with("2M")) {
    conditions.rate_bps = 2e6;
    conditions.burst_bytes = 16'384.0;  // the queue of an access point lets that much through at once
  }
  const auto loss = air.find("loss");
  if (loss != std::string::npos) conditions.loss = std::stod(air.substr(loss + 4)) / 100.0;
  if (air.ends_with("bursts")) {
    conditions.dead_for = milliseconds{300};
    conditions.dead_every = milliseconds{1000};
  }
  if (loss != std::string::npos || air == "bursts") return conditions;
  if (air == "no_multicast") {
    conditions.multicast = false;
  } else if (air != "clean" && air != "2M") {
    throw std::invalid_argument("no air is called " + air);
  }
  return conditions;
}

std::uint64_t seed_of(int run) {
  constexpr int kMostHosts = 100;
  return static_cast<std::uint64_t>(run * kMostHosts);
}

std::string title_of(const std::string& air) {
  if (air == "clean") return "0 %";
  if (air == "2M") return "2 Mbit/s";
  if (air == "bursts") return "bursts";
  if (air == "no_multicast") return "no multicast";
  const auto digits = air.find("loss") + 4;
  const std::string loss = air.substr(digits, air.find('+', digits) - digits) + " %";
  if (air.ends_with("bursts")) return loss + ", bursts";
  return air.starts_with("2M") ? "2 Mbit/s, " + loss : loss;
}

}  // namespace tandem::bench
