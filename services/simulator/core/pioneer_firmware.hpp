#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "robot/pioneer/core/packet.hpp"
#include "robot/pioneer/core/robot_parameters.hpp"
#include "robot/pioneer/core/sip.hpp"
#include "services/common/pose2.hpp"
#include "services/common/time.hpp"
#include "services/simulator/core/robot_body.hpp"
#include "services/simulator/core/wheels.hpp"

namespace tandem::simulator {

/// What the controller of a simulated robot is like.
struct FirmwareOptions {
  pioneer::Identity identity{"Tandem_Simulator", "Pioneer", "p2at"};
  pioneer::RobotParameters parameters;
  Duration watchdog = std::chrono::milliseconds{2000};  ///< Without a packet for so long the wheels stop.
  Duration sip_cycle = std::chrono::milliseconds{100};
  Duration stall_time = std::chrono::milliseconds{500};  ///< The motors rest so long after a stall.
  double battery_v = 12.8;
  bool extended_sips = false;  ///< With what newer robots append to the standard packet.
  bool has_gyro = false;
  std::uint8_t kinematics_delay_ms = 0;
};

/// What is broken at the wheels and buttons; may be changed at any time.
struct ControllerFaults {
  bool left_blocked = false;  ///< The wheel cannot turn: driven, it stalls.
  bool right_blocked = false;
  std::uint8_t front_bumpers = 0;  ///< Pressed by something that the world does not know of: bit i is segment i + 1.
  std::uint8_t rear_bumpers = 0;
  bool encoders_dead = false;  ///< The wheels turn and nothing is counted.
  Pose2 odometry_offset;       ///< Added to what is counted.
  std::optional<double> battery_v;
  std::uint8_t digital_in = 0;
};

/// The controller of a Pioneer: bytes of the P2OS protocol in and out, wheel speeds to the body.
///
/// With the quirks that make it dangerous: after a silence, or a stall, it goes on at the last speed it was told, by
/// itself; a connection outlives its host; the STOP button drops the motors and releasing it does not raise them.
/// Commands it does not know are ignored quietly.
class PioneerFirmware {
 public:
  PioneerFirmware(FirmwareOptions options, Time now);

  /// Takes bytes from the host; the answers to them.
  [[nodiscard]] pioneer::Bytes receive(std::span<const std::uint8_t> bytes, Time now);
  /// How the wheels turn during the next `dt_s`.
  [[nodiscard]] BodySpeed drive(double dt_s, Time now);
  /// What became of that: counts the wheels' way, unless they were blocked.
  void settle(const Pose2& wheel_motion, const Moved& moved, Time now);
  /// True when the next standard packet is due.
  [[nodiscard]] bool is_report_due(Time now) const { return open_ && now >= next_report_; }
  /// That packet, with `echoes` of the sonars fired since the last.
  [[nodiscard]] pioneer::Bytes report(std::vector<pioneer::SonarEcho> echoes, Time now);

  /// The red button: pressed, the motors drop; released, they stay off until ENABLE.
  void press_stop(bool pressed);
  /// Power off and on again: forgets the connection, odometry and every setting.
  void power_cycle(Time now);

  [[nodiscard]] ControllerFaults& faults() { return faults_; }

  [[nodiscard]] bool is_open() const { return open_; }
  [[nodiscard]] bool sonar_on() const { return sonar_on_; }
  [[nodiscard]] BodySpeed speed() const { return speed_; }
  [[nodiscard]] double half_track_m() const { return 1.0 / options_.parameters.half_track_per_m; }
  [[nodiscard]] const Pose2& odom_from_base() const { return odom_from_base_; }

 private:
  [[nodiscard]] pioneer::Bytes synchronize(const pioneer::Packet& packet, Time now);
  [[nodiscard]] pioneer::Bytes obey(const pioneer::HostCommand& command);
  [[nodiscard]] pioneer::Bytes config_packet() const;
  [[nodiscard]] pioneer::Bytes encoder_packet() const;
  [[nodiscard]] pioneer::Bytes io_packet() const;
  [[nodiscard]] pioneer::Bytes gyro_packet() const;
  /// Begins or ends a stream, as the argument of its command says; what is to be sent at once.
  [[nodiscard]] pioneer::Bytes start(bool& stream, int value, const pioneer::Bytes& one) const;
  void forget_goals();
  void steer_to_goals();
  void close();
  [[nodiscard]] bool is_stalled(Time now) const { return now < stalled_until_; }
  void stall(bool left, bool right, Time now);

  FirmwareOptions options_;
  ControllerFaults faults_;
  pioneer::PacketReceiver receiver_;
  int next_sync_ = 0;  ///< The sync the handshake waits for; 3: done, waiting for OPEN.
  bool open_ = false;
  bool motors_on_ = false;
  bool stop_pressed_ = false;
  bool sonar_on_ = true;
  BodySpeed told_;                     ///< The last speed the host asked for: it outlives the watchdog and a stall.
  BodySpeed speed_;                    ///< What the wheels do.
  std::optional<double> way_to_go_m_;  ///< of MOVE
  std::optional<double> heading_setpoint_;  ///< of HEAD and its kin
  bool encoder_stream_ = false;
  bool io_stream_ = false;
  bool gyro_on_ = false;
  double left_way_m_ = 0.0;
  double right_way_m_ = 0.0;
  std::uint8_t digital_out_ = 0;
  std::uint8_t analog_port_ = 0;
  Time last_packet_;
  Time next_report_;
  Time stalled_until_;
  bool left_stalled_ = false;  ///< in that stall
  bool right_stalled_ = false;
  Contact contact_;
  Pose2 odom_from_base_;
  double acceleration_mps2_ = 0.3;
  double deceleration_mps2_ = 0.3;
  double turn_acceleration_radps2_ = from_degrees(100.0);
  double turn_deceleration_radps2_ = from_degrees(100.0);
  double max_speed_mps_;
  double max_turn_rate_radps_;
  std::optional<double> tested_battery_v_;
};

}  // namespace tandem::simulator
