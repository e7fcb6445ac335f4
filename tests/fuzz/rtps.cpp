#include "services/bus/core/rtps_guard.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

using namespace tandem;
using fuzz::Bytes;

/// What a message says fits into it, and a guard lets no number pass that Fast DDS cannot bear.
void look_into(Bytes message) {
  const auto said = bus::submessages_of(message);
  if (said) fuzz::check(said->size() <= message.size() / 4);
  for (const bool secured : {false, true}) {
    bus::RtpsGuard guard{secured};
    const auto fault = guard.fault_of(message, Time{});
    fuzz::check((fault == bus::RtpsFault::NoMessage) == !said);
    if (fault) continue;
    for (const auto& submessage : *said) {
      fuzz::check(submessage.first >= 0 && submessage.last <= bus::RtpsGuard::kMostNumber);
      fuzz::check(submessage.kind != bus::RtpsSubmessage::Kind::Gap ||
                  submessage.last - submessage.first < bus::RtpsGuard::kMostGap);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Bytes input{data, size};
  look_into(input);
  // Behind a good header, which is hard to guess.
  std::vector<std::uint8_t> message{'R', 'T', 'P', 'S', 2, 3, 1, 15};
  message.resize(20);
  message.insert(message.end(), input.begin(), input.end());
  look_into(message);
  return 0;
}
