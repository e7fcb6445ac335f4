#include "services/simulator/simulator_service.hpp"

#include <poll.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <stdexcept>

#include "services/mapping/core/map_file.hpp"
#include "services/simulator/simulator_messages.hpp"

namespace tandem::simulator {
namespace {

constexpr Duration kStep = std::chrono::milliseconds{25};  ///< One turn of a UTM-30LX.
constexpr Duration kTruthPeriod = std::chrono::milliseconds{50};

SimulationOptions options_of(const SimulatorConfig& config, const Scenario& scenario) {
  const auto* parameters = pioneer::robot_parameters(config.robot_model);
  if (parameters == nullptr) {
    throw ConfigError("simulator.toml: robot_model: \"" + config.robot_model +
                      "\" is no Pioneer we know; p2at, p3at and p3dx are some");
  }
  SimulationOptions options;
  options.firmware.identity = {"Tandem_Simulator", "Pioneer", config.robot_model};
  options.firmware.parameters = *parameters;
  options.firmware.watchdog = std::chrono::milliseconds{config.watchdog_ms};
  options.firmware.sip_cycle = std::chrono::milliseconds{config.sip_cycle_ms};
  options.firmware.battery_v = config.battery_v;
  options.firmware.has_gyro = config.base_gyro;
  options.firmware.extended_sips = config.robot_model.ends_with("-sh");  // the newest controllers
  options.hull = {parameters->length_m, parameters->width_m};
  options.slip = {config.slip_distance_per_root_m, config.slip_turn_per_root_rad, config.slip_turn_per_root_m};
  options.base_from_laser = {config.laser_x_m, config.laser_y_m, 0.0};
  options.laser.noise_m = config.laser_noise_m;
  options.person_speed_mps = config.person_speed_mps;
  options.passers_by = scenario.passers_by;
  options.seed = static_cast<std::uint64_t>(config.seed);
  return options;
}

Simulation simulation_of(const SimulatorConfig& config, Time now) {
  const Scenario scenario = load_scenario(config.scenario);
  const std::filesystem::path map_file = config.map.empty() ? scenario.map_file : std::filesystem::path{config.map};
  const MapChoice choice = config.map.empty() ? MapChoice::OwnMap : MapChoice::OtherMap;
  Place place{load_map(map_file)};
  const auto seed = static_cast<std::uint64_t>(config.seed);
  const Scene scene = scene_of(scenario, place, choice, seed);
  spdlog::info(
      "scene: scenario={} map={} seed={} robot=({:.2f}, {:.2f}, {:.2f}) person=({:.2f}, {:.2f}) "
      "tokens=({:.2f}, {:.2f})",
      scenario.name, map_file.string(), seed, scene.robot_start.x, scene.robot_start.y, scene.robot_start.heading,
      scene.person_start.x, scene.person_start.y, scene.tokens_in_map[0].x(), scene.tokens_in_map[0].y());
  const bool nobody = config.person == "none" || scenario.person_model == "none";
  return {options_of(config, scenario), std::move(place), scene, nobody ? nullptr : std::make_unique<ObedientPerson>(),
          now};
}

std::uint16_t port(std::int64_t value) {
  return static_cast<std::uint16_t>(value);
}

LaserServerOptions laser_options_of(const SimulatorConfig& config) {
  return {.address = config.address,
          .port = port(config.laser_port),
          .pty = config.laser_pty,
          .model = config.laser_model,
          .boot = from_seconds(config.laser_boot_s)};
}

}  // namespace

SimulatorService::SimulatorService(const SimulatorConfig& config, const SiteConfig& site, bus::Bus& bus, Clock& clock)
    : site_(site),
      clock_(clock),
      simulation_(simulation_of(config, clock.now())),
      base_(config.address, port(config.base_port), config.base_pty),
      ground_truth_(bus.writer(topic::kGroundTruth)),
      health_(bus, site, "simulator"),
      next_step_(clock.now() + kStep),
      next_truth_(clock.now()) {
  if (config.laser_port != 0 || !config.laser_pty.empty()) {
    laser_.emplace(laser_options_of(config), clock.now());
  }
  if (config.camera_port != 0) {
    camera_.emplace(config.address, port(config.camera_port), from_seconds(1.0 / config.camera_rate_hz), clock.now());
  }
  if (simulation_.has_person() && !config.phone_pairing_file.empty()) {
    phone_ = make_phone(config.phone_pairing_file, site.agent);
  }
  if (config.fault_port != 0) faults_.emplace(config.address, port(config.fault_port), breakables());
}

std::vector<FaultServer::Breakable> SimulatorService::breakables() {
  std::vector<FaultServer::Breakable> devices;
  devices.push_back({"base", [this](HardwareFault fault) {
                       spdlog::info("fault: device=base fault={}", name_of(fault));
                       simulation_.set_base_fault(fault, clock_.now());
                     }});
  if (laser_) {
    devices.push_back({"laser", [this](HardwareFault fault) {
                         spdlog::info("fault: device=laser fault={}", name_of(fault));
                         laser_->set_fault(fault, clock_.now());
                       }});
  }
  return devices;
}

std::string SimulatorService::description() const {
  return "base=" + std::to_string(base_.port()) + " pty=" + base_.pty_path() +
         " laser=" + std::to_string(laser_ ? laser_->port() : 0) +
         " camera=" + std::to_string(camera_ ? camera_->port() : 0) +
         " person=" + (simulation_.has_person() ? site_.agent : "none");
}

void SimulatorService::step() {
  wait_for_clients(next_step_);
  const Time now = clock_.now();
  base_.receive(simulation_, now);
  if (laser_) laser_->receive(now);
  if (camera_) camera_->receive();
  if (faults_) faults_->receive();
  if (now < next_step_) return;
  constexpr Duration kTooLate = std::chrono::milliseconds{500};
  if (now - next_step_ > kTooLate) {
    spdlog::warn("the world stood still: s={:.2f}", to_seconds(now - next_step_));
    next_step_ = now;
  }
  for (; next_step_ <= now; next_step_ += kStep) advance(next_step_);
}

void SimulatorService::wait_for_clients(Time until) {
  std::vector<int> descriptors;
  base_.add_descriptors(descriptors);
  if (laser_) laser_->add_descriptors(descriptors);
  if (camera_) camera_->add_descriptors(descriptors);
  if (faults_) faults_->add_descriptors(descriptors);
  std::vector<pollfd> polled;
  polled.reserve(descriptors.size());
  for (const int descriptor : descriptors) polled.push_back({descriptor, POLLIN, 0});
  const Duration left = std::max(until - clock_.now(), Duration::zero());
  const timespec timeout{.tv_sec = 0, .tv_nsec = std::min<long>(left.count(), 100'000'000)};
  ::ppoll(polled.data(), polled.size(), &timeout, nullptr);  // an early return does no harm
}

void SimulatorService::advance(Time now) {
  const double dt_s = to_seconds(kStep);
  simulation_.step(dt_s, now);
  const auto view = phone_ ? phone_->view(now) : Simulation::PhoneView{};
  for (const auto& message : simulation_.step_person(view, dt_s, now)) {
    if (phone_) phone_->press(message, now);
  }
  base_.report(simulation_, now);
  if (laser_) laser_->step(simulation_, now - kStep, kStep);
  if (camera_) camera_->step(simulation_, now);
  publish(now);
}

void SimulatorService::publish(Time now) {
  health_.step(msg::HEALTH_OK);
  if (now < next_truth_) return;
  next_truth_ = std::max(next_truth_ + kTruthPeriod, now);
  ground_truth_.write(ground_truth_message(simulation_, site_.robot, site_.agent, now));
}

}  // namespace tandem::simulator
