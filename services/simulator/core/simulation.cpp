#include "services/simulator/core/simulation.hpp"

#include <algorithm>
#include <cmath>

#include "services/mapping/core/ray_casting.hpp"

namespace tandem::simulator {
namespace {

constexpr double kSightRange_m = 3.0;
constexpr double kRobotBodyRadius_m = 0.4;

std::string text_of(const pioneer::Bytes& bytes) {
  return {bytes.begin(), bytes.end()};
}
pioneer::Bytes bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

}  // namespace

Simulation::Simulation(SimulationOptions options, Place place, const Scene& scene, std::unique_ptr<PhoneUser> person,
                       Time now)
    : options_(std::move(options)),
      place_(std::move(place)),
      scene_(scene),
      laser_rng_(options_.seed + 1),
      person_rng_(options_.seed + 2),
      body_(options_.hull, options_.slip, scene.robot_start, Rng{options_.seed + 3}),
      map_from_base_before_(scene.robot_start),
      firmware_(options_.firmware, now),
      base_rng_(options_.seed + 5),
      base_line_(options_.seed + 6),
      camera_(options_.camera),
      ground_(place_.largest_ground(kRobotRoom_m)),
      person_(std::move(person)),
      walker_(scene.person_start) {
  Rng rng{options_.seed + 4};
  for (std::int64_t i = 0; i < options_.passers_by && !ground_.empty(); ++i) {
    passers_by_.emplace_back(ground_, rng.fork());
  }
}

void Simulation::step(double dt_s, Time now) {
  const auto people = bodies_of_people();
  map_from_base_before_ = body_.map_from_base();
  const Pose2 wheel_motion = arc(firmware_.drive(dt_s, now), dt_s);
  firmware_.settle(wheel_motion, body_.move(wheel_motion, place_, people), now);
  const Disc robot{body_.map_from_base().position(), kRobotBodyRadius_m};
  for (std::size_t i = 0; i < passers_by_.size(); ++i) {
    std::vector<Disc> others{robot};
    for (std::size_t j = 0; j < passers_by_.size(); ++j) {
      if (j != i) others.push_back(passers_by_[j].walker().body());
    }
    if (person_) others.push_back(walker_.body());
    passers_by_[i].step(dt_s, place_, ground_, others);
  }
}

std::vector<PhoneMessage> Simulation::step_person(const PhoneView& view, double dt_s, Time now) {
  if (!person_) return {};
  PhoneUserInput input;
  input.now = now;
  input.dt_s = dt_s;
  input.map_from_person = walker_.map_from_person();
  input.walking = !route_.finished();
  input.connected = view.connected;
  input.computing = view.computing;
  input.search_over = view.search_over;
  input.replan_refused = view.replan_refused;
  input.plan = view.plan;
  input.visible_token_in_map = token_in_sight();
  auto decision = person_->step(input, person_rng_);
  seen_by_person_ = seen_by_person_ || decision.found;
  if (decision.new_route_in_map) route_ = Route{std::move(*decision.new_route_in_map)};
  std::vector<Disc> others{{body_.map_from_base().position(), kRobotBodyRadius_m}};
  for (const auto& passer_by : passers_by_) others.push_back(passer_by.walker().body());
  if (route_.finished()) {
    constexpr double kLookAround_radps = 0.3;
    walker_.stand(view.search_over ? 0.0 : kLookAround_radps, dt_s);
  } else {
    route_.follow(walker_, options_.person_speed_mps, dt_s, place_, others);
  }
  return std::move(decision.messages);
}

std::optional<Eigen::Vector2d> Simulation::token_in_sight() const {
  const Eigen::Vector2d eyes = walker_.map_from_person().position();
  for (const auto& token : scene_.tokens_in_map) {
    if ((token - eyes).norm() <= kSightRange_m && line_of_sight(place_.map(), eyes, token)) return token;
  }
  return std::nullopt;
}

void Simulation::set_base_fault(HardwareFault fault, Time now) {
  if (fault == HardwareFault::Off) {
    firmware_.power_cycle(now);
    last_report_.clear();
  }
  base_line_.set(fault, now);
}

pioneer::Bytes Simulation::base_receive(std::span<const std::uint8_t> bytes, Time now) {
  if (!base_line_.hears(now)) return {};
  return bytes_of(base_line_.pass(text_of(firmware_.receive(bytes, now)), now));
}

pioneer::Bytes Simulation::base_report(Time now) {
  std::string arriving = base_line_.due(now);
  if (firmware_.is_report_due(now)) arriving += base_line_.pass_message(text_of(measured_report(now)), now);
  return bytes_of(arriving);
}

pioneer::Bytes Simulation::measured_report(Time now) {
  constexpr double kAnywhere_m = 30.0;
  const HardwareFault fault = base_line_.fault();
  Pose2& offset = firmware_.faults().odometry_offset;
  const Pose2 usual = offset;
  if (fault == HardwareFault::Wrong) {
    offset = {base_rng_.uniform() * kAnywhere_m, base_rng_.uniform() * kAnywhere_m, usual.heading};
  }
  pioneer::Bytes report = firmware_.report(fire_sonars(), now);
  offset = usual;
  if (fault == HardwareFault::Stuck && !last_report_.empty()) return last_report_;
  return last_report_ = std::move(report);
}

std::vector<pioneer::SonarEcho> Simulation::fire_sonars() {
  std::vector<pioneer::SonarEcho> echoes;
  constexpr int kSonarsPerReport = 4;
  constexpr double kNoEcho_m = 5.0;
  const auto sonars = pioneer::sonar_poses(options_.firmware.parameters);
  if (sonars.empty() || !firmware_.sonar_on()) return echoes;
  const auto people = bodies_of_people();
  for (int i = 0; i < kSonarsPerReport; ++i) {
    const Pose2 map_from_sonar = body_.map_from_base() * sonars[next_sonar_];
    double range = range_to_obstacle_m(place_.map(), map_from_sonar.position(), map_from_sonar.heading, kNoEcho_m)
                       .value_or(kNoEcho_m);
    for (const auto& person : people) {
      range = std::min(range, range_to_disc_m(map_from_sonar.position(), map_from_sonar.heading, person));
    }
    const double counts = range / options_.firmware.parameters.metres_per_range;
    echoes.push_back({static_cast<std::uint8_t>(next_sonar_), static_cast<std::uint16_t>(std::lround(counts))});
    next_sonar_ = (next_sonar_ + 1) % sonars.size();
  }
  return echoes;
}

std::vector<double> Simulation::scan(std::span<const Beam> beams) {
  std::vector<Disc> legs;
  const auto add = [&legs](const Walker& walker) {
    for (const auto& leg : walker.legs()) legs.push_back(leg);
  };
  for (const auto& passer_by : passers_by_) add(passer_by.walker());
  if (person_) add(walker_);
  return cast(beams, map_from_base_before_ * options_.base_from_laser, body_.map_from_base() * options_.base_from_laser,
              place_, legs, options_.laser, laser_rng_);
}

Picture Simulation::picture() const {
  return camera_.draw(body_.map_from_base(), place_, bodies_of_people(), scene_.tokens_in_map);
}

TrueBody Simulation::robot() const {
  const BodySpeed speed = firmware_.speed();
  return {"robot", body_.map_from_base(), speed.forward_mps, speed.turn_rate_radps};
}

std::vector<TrueBody> Simulation::people() const {
  std::vector<TrueBody> all;
  if (person_) all.push_back({"person", walker_.map_from_person(), walker_.speed_mps(), 0.0});
  for (const auto& passer_by : passers_by_) {
    const auto& walker = passer_by.walker();
    all.push_back({"passer_by" + std::to_string(&passer_by - passers_by_.data() + 1), walker.map_from_person(),
                   walker.speed_mps(), 0.0});
  }
  return all;
}

std::vector<Disc> Simulation::bodies_of_people() const {
  std::vector<Disc> bodies;
  if (person_) bodies.push_back(walker_.body());
  for (const auto& passer_by : passers_by_) bodies.push_back(passer_by.walker().body());
  return bodies;
}

}  // namespace tandem::simulator
