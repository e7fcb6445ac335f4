#include "robot/laser/core/scip.hpp"

#include "robot/laser/core/scip_reading.hpp"
#include "robot/laser/core/scip_session.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

using namespace tandem;
using fuzz::Bytes;

void look_into(const scip::Reply& reply) {
  (void)scip::parse_parameters(reply.data);
  const auto scan = scip::parse_scan(reply);
  if (!scan) return;
  fuzz::check(scan->ranges_mm.size() == scip::value_count(scan->request));
  (void)reading_of(*scan, scip::utm_30lx(), Time{}, 30.0);
}

/// The second whole reply after anything is read.
void finds_back(Bytes input) {
  scip::ReplyParser parser;
  (void)parser.take(input);
  const std::string good = scip::bytes_of(scip::Reply{.echo = "QT", .status = "00", .data = {}});
  (void)parser.take(fuzz::bytes_of(good));
  fuzz::check(parser.take(fuzz::bytes_of(good)).size() == 1);
}

/// Each line gets a good checksum, so that what lies behind the checksums is reached.
void with_good_checksums(Bytes input) {
  scip::LineReader lines;
  scip::Reply reply{.echo = "MD0000000200000", .status = "99", .data = {}};
  const auto all = lines.take(input);
  if (!all.empty()) reply.echo = all[0];
  for (std::size_t i = 1; i < all.size(); ++i) reply.data.push_back(all[i]);
  look_into(reply);
  (void)scip::parse_request(reply.echo);
}

void a_session_lives(Bytes input) {
  Time now{};
  LaserConfig config;
  ScipSession session{config, now, 115'200};
  (void)session.step({}, now);
  for (const char* echo : {"QT", "RS", "VV", "PP", "II", "BM"}) {
    scip::Reply reply{.echo = echo, .status = "00", .data = {}};
    if (reply.echo == "PP") reply.data = scip::parameter_lines(scip::utm_30lx());
    now += std::chrono::milliseconds{200};
    (void)session.step(fuzz::bytes_of(scip::bytes_of(reply)), now);
    now += std::chrono::milliseconds{200};
    (void)session.step({}, now);
    if (reply.echo[0] == static_cast<char>(input.empty() ? 0 : input[0])) break;
  }
  fuzz::in_pieces(input, [&](Bytes piece) {
    now += std::chrono::milliseconds{1};
    (void)session.step(piece, now);
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Bytes input{data, size};
  for (const auto& reply : fuzz::taken_whole_and_in_pieces(input, scip::ReplyParser{})) look_into(reply);
  with_good_checksums(input);
  if (fuzz::is_chosen(input)) {
    finds_back(input);
    a_session_lives(input);
  }
  return 0;
}
