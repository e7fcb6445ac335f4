#pragma once

#include <cstdint>
#include <string>

#include "services/common/config.hpp"
#include "services/simulator/core/laser_device.hpp"

namespace tandem::simulator {

/// config/simulation/robot/simulator.toml
struct SimulatorConfig {
  std::string scenario = "config/scenarios/brl.json";  ///< The episode: map, starts, tokens, people.
  std::string map;                                     ///< A map_server YAML file instead of the scenario's own.
  std::int64_t seed = 1;
  std::string person = "scenario";  ///< "none": nobody holds the simulated phone, a real one is played with.
  std::string phone_pairing_file;   ///< Holds the pairing link of the person's phone; waited for. Empty: no phone.
  double person_speed_mps = 0.75;

  std::string address = "127.0.0.1";  ///< Where robot, laser and camera listen.
  std::int64_t base_port = 8101;      ///< P2OS over TCP; 0: none.
  std::string base_pty;               ///< A link to the pseudo terminal of the base; empty: none.
  std::string robot_model = "p2at";
  std::int64_t watchdog_ms = 500;  ///< Of the firmware; 2000 in the factory.
  std::int64_t sip_cycle_ms = 100;
  double battery_v = 12.8;
  bool base_gyro = false;  ///< The controller has a gyro.

  std::int64_t laser_port = 10940;  ///< The laser over TCP; 0: none.
  std::string laser_pty;            ///< A link to the pseudo terminal of the laser; empty: none.
  std::string laser_model = "utm-30lx";
  double laser_boot_s = 0.0;  ///< Silent for so long after it gets power.
  double laser_x_m = 0.16;    ///< On the base, looking ahead.
  double laser_y_m = 0.0;
  double laser_noise_m = 0.01;  ///< Standard deviation of a range.

  std::int64_t camera_port = 8090;  ///< MJPEG over HTTP, /stream.mjpeg; 0: none.
  double camera_rate_hz = 5.0;

  std::int64_t fault_port = 0;  ///< Orders to break the hardware, "laser stuck"; 0: none are taken.

  double slip_distance_per_root_m = 0.01;  ///< Wheel slip: see SlipModel.
  double slip_turn_per_root_rad = 0.02;
  double slip_turn_per_root_m = 0.01;

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    visitor.field("scenario", scenario);
    visitor.field("map", map);
    visitor.field("seed", seed, Range{0, 4294967295});
    visitor.field("person", person, {"scenario", "none"});
    visitor.field("phone_pairing_file", phone_pairing_file);
    visitor.field("person_speed_mps", person_speed_mps, Range{0.1, 3.0});
    visitor.field("address", address);
    visitor.field("base_port", base_port, Range{0, 65535});
    visitor.field("base_pty", base_pty);
    visitor.field("robot_model", robot_model);
    visitor.field("watchdog_ms", watchdog_ms, Range{100, 10000});
    visitor.field("sip_cycle_ms", sip_cycle_ms, Range{25, 250});
    visitor.field("battery_v", battery_v, Range{0, 60});
    visitor.field("base_gyro", base_gyro);
    visitor.field("laser_port", laser_port, Range{0, 65535});
    visitor.field("laser_pty", laser_pty);
    visitor.field("laser_model", laser_model, laser_models());
    visitor.field("laser_boot_s", laser_boot_s, Range{0, 120});
    visitor.field("laser_x_m", laser_x_m, Range{-2, 2});
    visitor.field("laser_y_m", laser_y_m, Range{-2, 2});
    visitor.field("laser_noise_m", laser_noise_m, Range{0, 1});
    visitor.field("camera_port", camera_port, Range{0, 65535});
    visitor.field("camera_rate_hz", camera_rate_hz, Range{0.1, 20});
    visitor.field("fault_port", fault_port, Range{0, 65535});
    visitor.field("slip_distance_per_root_m", slip_distance_per_root_m, Range{0, 1});
    visitor.field("slip_turn_per_root_rad", slip_turn_per_root_rad, Range{0, 1});
    visitor.field("slip_turn_per_root_m", slip_turn_per_root_m, Range{0, 1});
  }
};

}  // namespace tandem::simulator
