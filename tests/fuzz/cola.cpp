#include "robot/laser/core/cola_scan.hpp"
#include "robot/laser/core/cola_session.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

using namespace tandem;
using fuzz::Bytes;

void look_into(std::string_view text) {
  const auto scan = cola::parse_scan(text);
  if (!scan) return;
  (void)cola::device_scan_of(*scan, 20.0);
  (void)cola::complaint_of(scan->status);
  const std::string again = cola::text_of(*scan, "sSN");
  const auto back = cola::parse_scan(again);
  fuzz::check(back.has_value() && back->channels.size() == scan->channels.size());
}

/// The input behind the words that every scan begins with.
void as_a_scan(Bytes input) {
  std::string text = "sSN LMDscandata 1 1 1 0 0 1 1 1 1 0 0 0 0 0 ";
  text.append(input.begin(), input.end());
  look_into(text);
}

void finds_back(Bytes input) {
  cola::TelegramReader reader;
  (void)reader.take(input);
  fuzz::check(!reader.take(fuzz::bytes_of("\x02sAN Run 1\x03")).empty());
}

/// A session that has come as far as the first byte says.
void a_session_lives(Bytes input) {
  Time now{};
  ColaSession session{LaserConfig{}, now};
  (void)session.step({}, now);
  const std::vector<std::string> good{"sEA LMDscandata 0",  "sRA DeviceIdent x",  "sAN SetAccessMode 1",
                                      "sWA LMDscandatacfg", "sAN LMCstartmeas 0", "sAN Run 1",
                                      "sRA STlms 7",        "sEA LMDscandata 1"};
  for (std::size_t i = 0; i < good.size() && i < input[0] % 12U; ++i) {
    (void)session.step(fuzz::bytes_of(cola::bytes_of(good[i])), now);
  }
  fuzz::in_pieces(input, [&](Bytes piece) {
    now += std::chrono::milliseconds{1};
    (void)session.step(piece, now);
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Bytes input{data, size};
  for (const auto& text : fuzz::taken_whole_and_in_pieces(input, cola::TelegramReader{})) look_into(text);
  as_a_scan(input);
  if (fuzz::is_chosen(input)) {
    finds_back(input);
    a_session_lives(input);
  }
  return 0;
}
