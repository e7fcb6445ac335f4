#include <algorithm>

#include "robot/laser/core/lms_message.hpp"
#include "robot/laser/core/lms_reading.hpp"
#include "robot/laser/core/lms_session.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

using namespace tandem;
using fuzz::Bytes;

void look_into(const lms::Payload& payload) {
  const auto scan = lms::parse_scan(payload);
  if (!scan) return;
  fuzz::check(!scan->values.empty() && scan->values.size() <= 1023);
  const DeviceScan out = device_scan_of(*scan, {}, {.measuring_mode = scan->status, .millimetres = true}, 38'400, 80.0);
  fuzz::check(out.reading.ranges_m.size() == scan->values.size());
}

/// The input as a payload, in a telegram that is good.
void in_a_good_telegram(Bytes input) {
  if (input.empty() || input.size() > lms::kMostPayload) return;
  lms::TelegramReader reader{lms::kFromLaser};
  const auto events = reader.take(fuzz::bytes_of(lms::bytes_of(lms::kFromLaser, input)));
  fuzz::check(events.size() == 1 && std::equal(input.begin(), input.end(), events[0].payload.begin()));
  look_into(events[0].payload);
}

/// Of two scans after anything the second is read, unless what came before makes a telegram whose CRC is right by
/// chance.
void finds_back(Bytes input) {
  static const lms::Payload scan = lms::payload_of({.values = std::vector<std::uint16_t>(361, 1000)});
  static const std::string good = lms::bytes_of(lms::kFromLaser, scan);
  lms::TelegramReader reader{lms::kFromLaser};
  (void)reader.take(input);
  auto events = reader.take(fuzz::bytes_of(good));
  for (auto& event : reader.take(fuzz::bytes_of(good))) events.push_back(std::move(event));
  const bool by_chance = std::any_of(events.begin(), events.end(), [](const lms::Event& event) {
    return event.kind == lms::Event::Kind::Telegram && event.payload != scan;
  });
  fuzz::check(by_chance || (!events.empty() && events.back().payload == scan));
}

/// A session that has come as far as the first byte says gets the rest as payloads.
void a_session_lives(Bytes input) {
  Time now{};
  LaserConfig config;
  config.range_format = "32m";
  LmsSession session{config, now, 9'600};
  (void)session.step({}, now);
  const std::vector<lms::Payload> good{{0xA0, 0, 0}, {0xBA, 'L', 0}, {0xB1, 0},    {0xF4, 0, 0, 0, 0, 0, 0, 0, 0, 0},
                                       {0xA0, 0, 0}, {0xF7, 1, 0},   {0xBB, 1, 0}, {0xA0, 0, 0}};
  for (std::size_t i = 0; i < good.size() && i < input[0] % 12U; ++i) {
    now += std::chrono::milliseconds{50};
    (void)session.step(fuzz::bytes_of(lms::bytes_of(lms::kFromLaser, good[i])), now);
  }
  Bytes left = input;
  while (!left.empty()) {
    const std::size_t length = std::min<std::size_t>(left.size(), 1 + left[0] % 32U);
    now += std::chrono::milliseconds{50};
    (void)session.step(fuzz::bytes_of(lms::bytes_of(lms::kFromLaser, left.first(length))), now);
    left = left.subspan(length);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Bytes input{data, size};
  (void)fuzz::taken_whole_and_in_pieces(input, lms::TelegramReader{lms::kFromLaser});
  in_a_good_telegram(input);
  if (fuzz::is_chosen(input)) {
    finds_back(input);
    a_session_lives(input);
  }
  return 0;
}
