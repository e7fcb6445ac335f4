#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "services/simulator/core/camera_view.hpp"
#include "services/simulator/core/hardware_fault.hpp"
#include "services/simulator/core/laser_view.hpp"
#include "services/simulator/core/obedient_person.hpp"
#include "services/simulator/core/pioneer_firmware.hpp"
#include "services/simulator/core/scenario.hpp"
#include "services/simulator/core/walker.hpp"

namespace tandem::simulator {

/// What a simulated episode is made of.
struct SimulationOptions {
  FirmwareOptions firmware;
  Hull hull;
  SlipModel slip;
  Pose2 base_from_laser{0.16, 0.0, 0.0};
  RangeModel laser;
  CameraModel camera;
  double person_speed_mps = 0.75;
  std::int64_t passers_by = 0;
  std::uint64_t seed = 1;
};

/// A person or the robot as they truly are.
struct TrueBody {
  std::string id;
  Pose2 map_from_body;
  double forward_mps = 0.0;
  double turn_rate_radps = 0.0;
};

/// Everything that moves, in steps handed in. Equal options, scenes and inputs give equal episodes.
///
/// The one place where what is true is known; the outside sees it through firmware, laser, camera and phone alone.
class Simulation {
 public:
  /// The person is there, and is called `person_id`, if `person` is given.
  Simulation(SimulationOptions options, Place place, const Scene& scene, std::unique_ptr<PhoneUser> person, Time now);

  /// Moves robot and passers-by from `now` - `dt_s` to `now`.
  void step(double dt_s, Time now);
  /// Moves the person too: what the phone shows goes in, what is pressed comes out.
  struct PhoneView {
    bool connected = false;
    bool computing = false;
    bool search_over = false;
    bool replan_refused = false;
    std::optional<PhonePlan> plan = {};
  };
  [[nodiscard]] std::vector<PhoneMessage> step_person(const PhoneView& view, double dt_s, Time now);

  [[nodiscard]] PioneerFirmware& firmware() { return firmware_; }
  [[nodiscard]] FaultyLine& base_line() { return base_line_; }
  /// Breaks the base, or mends it; a base without power has forgotten all when it comes back.
  void set_base_fault(HardwareFault fault, Time now);
  /// Takes bytes from the base's host; what it gets back at once.
  [[nodiscard]] pioneer::Bytes base_receive(std::span<const std::uint8_t> bytes, Time now);
  /// What reaches the base's host at `now`: the standard packet if one is due, with a few sonar echoes.
  [[nodiscard]] pioneer::Bytes base_report(Time now);
  /// Ranges of a turn of the laser during the last step [m].
  [[nodiscard]] std::vector<double> scan(std::span<const Beam> beams);
  [[nodiscard]] Picture picture() const;

  [[nodiscard]] TrueBody robot() const;
  [[nodiscard]] std::vector<TrueBody> people() const;
  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] bool has_person() const { return person_ != nullptr; }
  [[nodiscard]] bool seen_by_person() const { return seen_by_person_; }
  [[nodiscard]] int collisions() const { return body_.collisions(); }
  [[nodiscard]] WheelSpeeds wheels() const { return wheels_of(firmware_.speed(), firmware_.half_track_m()); }

 private:
  [[nodiscard]] std::vector<Disc> bodies_of_people() const;
  /// What the base's controller reports: what it measures, unless it is stuck or wrong.
  [[nodiscard]] pioneer::Bytes measured_report(Time now);
  [[nodiscard]] std::vector<pioneer::SonarEcho> fire_sonars();
  [[nodiscard]] std::optional<Eigen::Vector2d> token_in_sight() const;

  SimulationOptions options_;
  Place place_;
  Scene scene_;
  Rng laser_rng_;
  Rng person_rng_;
  RobotBody body_;
  Pose2 map_from_base_before_;
  PioneerFirmware firmware_;
  Rng base_rng_;
  FaultyLine base_line_;
  pioneer::Bytes last_report_;  ///< of the base, while it is not stuck
  CameraView camera_;
  std::vector<Eigen::Vector2d> ground_;  ///< Where passers-by walk.
  std::vector<PasserBy> passers_by_;
  std::unique_ptr<PhoneUser> person_;
  Walker walker_;
  Route route_;
  bool seen_by_person_ = false;
  std::size_t next_sonar_ = 0;
};

}  // namespace tandem::simulator
