#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "services/common/time.hpp"

/// The P2OS serial protocol of Pioneer robots (P2OS, AROS, ARCOS), both directions: driver and simulator share it.
namespace tandem::pioneer {

using Bytes = std::vector<std::uint8_t>;

/// Host to robot. During the handshake 0, 1 and 2 are SYNC0, SYNC1 and SYNC2; afterwards Pulse, Open and Close.
enum class Command : std::uint8_t {
  Pulse = 0,
  Open = 1,
  Close = 2,
  Polling = 3,
  Enable = 4,
  SetTranslationalAcceleration = 5,  ///< SETA [mm/s^2], negative: deceleration
  SetMaxSpeed = 6,                   ///< SETV [mm/s]
  SetOrigin = 7,                     ///< SETO
  Move = 8,                          ///< [mm], at the maximum speed
  SetMaxTurnRate = 10,               ///< SETRV [deg/s]
  Velocity = 11,                     ///< VEL [mm/s]
  Heading = 12,                      ///< HEAD [deg]
  DeltaHeading = 13,                 ///< DHEAD [deg]
  Config = 18,
  Encoder = 19,                   ///< 1 one ENCODERpac, 2 a stream, 0 none
  DeltaHeadingFromSetpoint = 22,  ///< DCHEAD [deg]
  TurnRate = 21,                  ///< RVEL [deg/s], counter-clockwise positive
  SetTurnAcceleration = 23,       ///< SETRA [deg/s^2], negative: deceleration
  Sonar = 28,
  Stop = 29,
  DigitalOut = 30,       ///< high byte mask, low byte values
  WheelVelocities = 32,  ///< VEL2: low byte right, high byte left
  AnalogSelect = 35,     ///< ADSEL
  IoRequest = 40,        ///< 1 one IOpac, 2 a stream, 0 none
  BumpStall = 44,
  EmergencyStop = 55,
  QuickStop = 57,
  Gyro = 58,          ///< 1 GYROpacs on
  BatteryTest = 250,  ///< BATTEST [0.1 V], 0 restores
};

/// Robot to host, first byte of the packet.
namespace packet_type {
inline constexpr std::uint8_t kSync0 = 0;
inline constexpr std::uint8_t kSync1 = 1;
inline constexpr std::uint8_t kSync2 = 2;
inline constexpr std::uint8_t kConfig = 0x20;
inline constexpr std::uint8_t kEncoder = 0x90;
inline constexpr std::uint8_t kGyro = 0x98;
inline constexpr std::uint8_t kIo = 0xF0;
inline constexpr std::uint8_t kSipStopped = 0x32;
inline constexpr std::uint8_t kSipMoving = 0x33;
inline constexpr std::uint8_t kSyncCounterOff = 255;
/// Standard information packets; which of them says nothing reliable about motion.
[[nodiscard]] inline constexpr bool is_sip(std::uint8_t number) {
  return number >= 0x30 && number <= 0x34;
}
}  // namespace packet_type

/// A packet without its frame: command number or packet type, then argument or fields.
struct Packet {
  std::uint8_t number = 0;
  Bytes body;
  Time first_byte{};  ///< When its first byte arrived; nothing on the wire.

  friend bool operator==(const Packet& a, const Packet& b) { return a.number == b.number && a.body == b.body; }
};

/// Largest body (COUNT <= 200).
inline constexpr std::size_t kMaxBody = 197;

/// Sum of big-endian 16-bit words; a left-over byte is XORed into the low byte.
[[nodiscard]] std::uint16_t checksum(std::span<const std::uint8_t> bytes);

/// `packet` in its frame: FA FB COUNT number body checksum. At most kMaxBody bytes of body.
[[nodiscard]] Bytes framed(const Packet& packet);

/// A command without argument, ready to be sent.
[[nodiscard]] Bytes command(Command command);
/// A command with an integer argument: sign in the type byte, then the magnitude (at most 32767; larger is clamped).
[[nodiscard]] Bytes command(Command command, int argument);
/// A command whose 16 bits are two bytes (VEL2, DIGOUT).
[[nodiscard]] Bytes packed_command(Command command, std::uint8_t high, std::uint8_t low);

/// What a host sent, decoded: for the simulator's side.
struct HostCommand {
  std::uint8_t number = 0;
  std::variant<std::monostate, int, std::string> argument;

  /// The integer argument, or `otherwise` where there is none.
  [[nodiscard]] int integer_or(int otherwise) const;
  /// The argument's 16 bits, for commands that pack two bytes; ARIA sends 65536 - value with a negative sign.
  [[nodiscard]] std::uint16_t packed_bytes() const;
};

/// None if the argument is not one of the three types or is cut short.
[[nodiscard]] std::optional<HostCommand> decode_command(const Packet& packet);

/// Names of the robot, its class ("Pioneer") and subclass ("p2at"): the answer to SYNC2.
struct Identity {
  std::string name;
  std::string robot_class;
  std::string subclass;

  friend bool operator==(const Identity&, const Identity&) = default;
};
[[nodiscard]] Packet encode_identity(const Identity& identity);
[[nodiscard]] std::optional<Identity> decode_identity(const Packet& packet);

/// Finds packets in a stream of bytes, whatever lies between them and however they are cut.
///
/// A packet whose checksum is wrong, or whose rest does not come within kPatience, costs only its two header bytes:
/// the search goes on behind them.
class PacketReceiver {
 public:
  static constexpr Duration kPatience = std::chrono::milliseconds{100};

  /// Takes `bytes` that arrived at `now`.
  void push(std::span<const std::uint8_t> bytes, Time now);
  /// The next whole packet; none until more bytes come.
  [[nodiscard]] std::optional<Packet> next();
  /// Forgets half a packet, after the link was reopened.
  void clear();

  [[nodiscard]] std::uint64_t bad_checksums() const { return bad_checksums_; }
  /// Bytes that belonged to no packet.
  [[nodiscard]] std::uint64_t skipped_bytes() const { return skipped_bytes_; }

 private:
  struct Arrived {
    std::uint8_t byte = 0;
    Time at{};
  };
  void drop(std::size_t count);

  std::vector<Arrived> buffer_;
  std::size_t settled_ = 0;  ///< bytes at the front of the buffer that came before a silence: never wait for their rest
  Time last_byte_{};
  std::uint64_t bad_checksums_ = 0;
  std::uint64_t skipped_bytes_ = 0;
};

}  // namespace tandem::pioneer
