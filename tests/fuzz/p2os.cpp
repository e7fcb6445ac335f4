#include "robot/pioneer/core/config_packet.hpp"
#include "robot/pioneer/core/extra_packets.hpp"
#include "robot/pioneer/core/session.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

using namespace tandem;
using fuzz::Bytes;

/// The receiver in the form of the other readers.
struct PacketReader {
  pioneer::PacketReceiver receiver;

  std::vector<pioneer::Packet> take(Bytes bytes) {
    receiver.push(bytes, Time{});
    std::vector<pioneer::Packet> packets;
    while (auto packet = receiver.next()) packets.push_back(std::move(*packet));
    return packets;
  }
  [[nodiscard]] std::uint64_t damaged() const { return receiver.bad_checksums(); }
};

/// What is decoded says the same once it has been encoded and decoded again.
template <typename Decode, typename Encode>
void survives(const pioneer::Packet& packet, Decode decode, Encode encode) {
  const auto decoded = decode(packet);
  if (decoded) fuzz::check(decode(encode(*decoded)) == decoded);
}

void look_into(const pioneer::Packet& packet) {
  constexpr std::size_t kMostEchoes = 32;  // that fit with all that may follow
  const auto sip = pioneer::decode_sip(packet);
  if (sip && sip->sonar.size() <= kMostEchoes) survives(packet, pioneer::decode_sip, pioneer::encode_sip);
  survives(packet, pioneer::decode_config, pioneer::encode_config);
  survives(packet, pioneer::decode_encoders, pioneer::encode_encoders);
  survives(packet, pioneer::decode_io, pioneer::encode_io);
  survives(packet, pioneer::decode_gyro, pioneer::encode_gyro);
  survives(packet, pioneer::decode_identity, pioneer::encode_identity);
  if (const auto command = pioneer::decode_command(packet)) {
    (void)command->integer_or(0);
    (void)command->packed_bytes();
  }
}

/// The input as number and body of a packet, in a frame that is good.
void in_a_good_frame(Bytes input) {
  if (input.empty() || input.size() > pioneer::kMaxBody + 1) return;
  const pioneer::Packet sent{input[0], {input.begin() + 1, input.end()}};
  const auto packets = PacketReader{}.take(pioneer::framed(sent));
  fuzz::check(packets.size() == 1 && packets[0] == sent);
  look_into(sent);
}

/// The second packet after anything is read: whatever took the first for its own rest ends with it.
void finds_back(Bytes input) {
  static const pioneer::Packet good{pioneer::packet_type::kSipStopped, pioneer::Bytes(pioneer::kMaxBody, 0)};
  PacketReader reader;
  (void)reader.take(input);
  (void)reader.take(pioneer::framed(good));
  const auto packets = reader.take(pioneer::framed(good));
  fuzz::check(!packets.empty() && packets.back() == good);
}

/// Whatever a controller answers, a session that was not told to drive switches no motor on and commands no speed.
void stands_still(const pioneer::Bytes& output) {
  for (const auto& packet : PacketReader{}.take(output)) {
    const auto command = pioneer::decode_command(packet);
    fuzz::check(command.has_value());
    const auto is = [&](pioneer::Command one) { return command->number == static_cast<std::uint8_t>(one); };
    if (is(pioneer::Command::Velocity) || is(pioneer::Command::TurnRate)) fuzz::check(command->integer_or(1) == 0);
    fuzz::check(!is(pioneer::Command::Enable) && !is(pioneer::Command::WheelVelocities));
  }
}

/// A session that has come as far in the handshake as the first byte says.
void a_session_lives(Bytes input) {
  Time now{std::chrono::seconds{1}};
  pioneer::Session session{{}};
  session.link_opened(now);
  const std::vector<pioneer::Packet> good{{0, {}},
                                          {1, {}},
                                          pioneer::encode_identity({"robot", "Pioneer", "p2at"}),
                                          pioneer::encode_sip({}),
                                          pioneer::encode_config({})};
  const auto go_on = [&](Bytes bytes, Duration later) {
    now += later;
    session.receive(bytes, now);
    session.step(now);
    stands_still(session.take_output());
    (void)session.take_events();
  };
  for (std::size_t i = 0; i < good.size() && i < input[0] % 8U; ++i) {
    go_on(pioneer::framed(good[i]), std::chrono::milliseconds{20});
  }
  fuzz::in_pieces(input, [&](Bytes piece) { go_on(piece, std::chrono::milliseconds{piece[0]}); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Bytes input{data, size};
  for (const auto& packet : fuzz::taken_whole_and_in_pieces(input, PacketReader{})) look_into(packet);
  in_a_good_frame(input);
  if (fuzz::is_chosen(input)) {
    finds_back(input);
    a_session_lives(input);
  }
  return 0;
}
