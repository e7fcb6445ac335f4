// Prints the true speed of the wheels whenever it changes, and since when, as JSON lines
// {"unix_ms": ..., "left_mps": ..., "right_mps": ...}.
// usage: wheel_watch DOMAIN
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

#include "idl/topics.hpp"
#include "services/bus/bus.hpp"
#include "services/common/stop_signal.hpp"

using namespace tandem;

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "usage: wheel_watch DOMAIN\n";
    return 2;
  }
  bus::DomainOptions options;
  options.domain = std::stoi(argv[1]);
  options.participant = "wheel-watch";
  bus::Bus bus{options};
  auto truth = bus.latest(topic::kGroundTruth);
  const StopSignal stop;
  double left = NAN;
  double right = NAN;
  while (!stop.requested()) {
    bus.wait(from_seconds(0.05));
    const auto now = truth.take_new();
    if (!now || (now->message.left_wheel_mps() == left && now->message.right_wheel_mps() == right)) continue;
    left = now->message.left_wheel_mps();
    right = now->message.right_wheel_mps();
    constexpr std::int64_t kNsPerMs = 1'000'000;
    std::cout << R"({"unix_ms":)" << now->message.stamp_ns() / kNsPerMs << R"(,"left_mps":)" << left << R"(,"right_mps":)" << right << "}" << std::endl;
  }
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::cerr << "wheel_watch cannot run: " << error.what() << "\n";
  return EXIT_FAILURE;
}
