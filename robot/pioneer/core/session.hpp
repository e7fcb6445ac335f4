#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "robot/pioneer/core/config_packet.hpp"
#include "robot/pioneer/core/extra_packets.hpp"
#include "robot/pioneer/core/packet.hpp"
#include "robot/pioneer/core/sip.hpp"
#include "services/common/time.hpp"

namespace tandem::pioneer {

/// What the controller is set to after each connection (SAF-1).
struct SessionConfig {
  int max_speed_mmps = 500;
  int max_turn_rate_degps = 60;
  int acceleration_mmps2 = 300;
  int deceleration_mmps2 = 600;
  int turn_acceleration_degps2 = 100;
  bool sonar = true;
};

/// The controller answered with who it is; its odometry counts anew.
struct Identified {
  Identity identity;
};
/// The controller told its parameters.
struct Configured {
  ConfigPacket config;
};
/// A standard packet came.
struct StatusReceived {
  Sip sip;
  Time first_byte{};
  std::size_t bytes = 0;  ///< of its packet on the line
};
/// Readings of the gyro came.
struct GyroReceived {
  std::vector<GyroReading> readings;
};
/// The controller was there and is no more.
struct Lost {
  std::string why;
};
/// Nobody answers on this link: close it, wait, and open another (another rate).
struct GaveUp {
  std::string why;
};
/// We were silent for so long that the controller may have stopped by itself: velocity 0 went first.
struct Gap {
  Duration silent{};
};
using SessionEvent = std::variant<Identified, Configured, StatusReceived, GyroReceived, Lost, GaveUp, Gap>;

/// The dialogue with a Pioneer's controller: bytes and time in, bytes and events out.
///
/// After OPEN, after any gap and after any stall the first command is velocity 0: the firmware would go on at its last
/// speed by itself. Motors are enabled only when asked to drive, and only after velocity 0. While they are on, each
/// step sends both velocities, so that a packet lost to noise is made good in the next; while they are off, a pulse is
/// sent.
///
/// Turning goes through RVEL, whose unit is 1 deg/s; VEL2 steps by 20 mm/s a wheel, about 2 deg/s, and is coarser ahead
/// too. What RVEL cannot say is carried over to the next command, so that slow turns come out right on average.
class Session {
 public:
  explicit Session(const SessionConfig& config) : config_(config) {}

  void link_opened(Time now);
  void link_closed();
  void receive(std::span<const std::uint8_t> bytes, Time now);
  /// To be called 20 times a second, after drive().
  void step(Time now);
  /// The velocity to send from now on; both are clamped to the config.
  void drive(double forward_mps, double turn_rate_radps);
  /// Velocity 0, motors off, and a moment later CLOSE. is_closed() when it is out.
  void begin_shutdown(Time now);

  [[nodiscard]] bool is_running() const { return state_ == State::Running; }
  [[nodiscard]] bool is_closed() const { return state_ == State::Closed; }
  /// What must be written to the link now.
  [[nodiscard]] Bytes take_output();
  [[nodiscard]] std::vector<SessionEvent> take_events();
  [[nodiscard]] const PacketReceiver& receiver() const { return receiver_; }

 private:
  enum class State { Closed, Draining, Syncing, Opening, Running, ShuttingDown };
  void start_syncing(Time now);
  void try_again(Duration drain, Time now);
  void give_up(const std::string& why);
  void take_sync_reply(const Packet& packet, Time now);
  void take_packet(const Packet& packet, Time now);
  void take_status(const Sip& sip, const Packet& packet, Time now);
  void open(Time now);
  void step_running(Time now);
  void send_velocities();
  void stand_still();
  void send(const Bytes& bytes);

  SessionConfig config_;
  State state_ = State::Closed;
  PacketReceiver receiver_;
  Bytes output_;
  std::vector<SessionEvent> events_;
  int stage_ = 0;     ///< of the handshake: 0, 1, 2
  int attempts_ = 0;  ///< of the handshake on this link
  Time deadline_{};   ///< of the present state
  std::string last_trouble_;
  std::optional<Time> last_sent_;
  Time last_status_{};
  Time last_enable_{};
  Time last_config_request_{};
  int config_requests_ = 0;
  bool configured_ = false;
  Sip status_;
  double forward_mps_ = 0.0;
  double turn_rate_radps_ = 0.0;
  double turn_remainder_degps_ = 0.0;
};

/// How long to wait before the next attempt to reach a device: 0.2 s, doubled up to 5 s; reset by success.
class BackOff {
 public:
  [[nodiscard]] Duration next();
  void reset() { wait_ = kFirst; }

 private:
  static constexpr Duration kFirst = std::chrono::milliseconds{200};
  static constexpr Duration kLongest = std::chrono::seconds{5};
  Duration wait_ = kFirst;
};

}  // namespace tandem::pioneer
