#include "robot/pioneer/base_service.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>

#include "robot/pioneer/base_messages.hpp"
#include "services/common/file_io.hpp"

namespace tandem {
namespace {

constexpr Duration kCycle = std::chrono::milliseconds{50};
constexpr Duration kStatusPeriod = std::chrono::milliseconds{500};
constexpr Duration kFrozen = std::chrono::seconds{1};

/// Larger than that of any earlier run, so that nobody takes two runs for one.
std::uint32_t first_epoch(Time now) {
  return static_cast<std::uint32_t>(std::chrono::duration_cast<std::chrono::seconds>(now.time_since_epoch()).count());
}

/// Whether two statuses say the same but for the time, the voltage and the countdown.
bool is_same_state(msg::BaseStatus a, msg::BaseStatus b) {
  a.stamp_ns(b.stamp_ns());
  a.battery_v(b.battery_v());
  a.resume_in_s(b.resume_in_s());
  return a == b;
}

}  // namespace

BaseService::BaseService(const BaseConfig& config, const SiteConfig& site, bus::Bus& bus, Clock& timer,
                         const Clock& mission)
    : config_(config),
      robot_(site.robot),
      timer_(timer),
      mission_(mission),
      link_(config, timer),
      gate_(config.gate),
      feed_(bus, site),
      odometry_(config.odometry, first_epoch(timer.now()), config.wheels),
      odometry_writer_(bus.writer(topic::kOdometry)),
      sonar_writer_(bus.writer(topic::kSonar)),
      status_writer_(bus.writer(topic::kBaseStatus)),
      health_(bus, site, "base") {
  if (!config_.marker_file.empty() && std::filesystem::exists(config_.marker_file)) {
    spdlog::warn("the last run ended while the motors were on: a resume is needed");
    gate_.take_service_failure();
  }
}

BaseService::~BaseService() {
  link_.shut_down();
  mark_driving(false);
}

void BaseService::mark_driving(bool driving) {
  if (config_.marker_file.empty() || driving == marked_) return;
  marked_ = driving;
  std::error_code ignored;  // a marker that cannot be written must not stop the robot from stopping
  if (!driving) {
    std::filesystem::remove(config_.marker_file, ignored);
    return;
  }
  try {
    write_file_atomically(config_.marker_file, "motors on\n");
  } catch (const FileError& error) {
    spdlog::warn("cannot mark that the motors are on: {}", error.what());
  }
}

void BaseService::step() {
  const Duration wait = std::clamp<Duration>(next_cycle_ - timer_.now(), Duration::zero(), kCycle);
  for (const auto& event : link_.exchange(wait)) take(event);
  const Time now = timer_.now();
  if (now < next_cycle_ && !contact_) return;
  contact_ = false;
  cycle();
  next_cycle_ = std::max(next_cycle_ + kCycle, now + kCycle / 2);
}

void BaseService::take(const pioneer::SessionEvent& event) {
  if (const auto* identified = std::get_if<pioneer::Identified>(&event)) take_identity(identified->identity);
  if (const auto* status = std::get_if<pioneer::StatusReceived>(&event)) take_status(*status);
  if (const auto* configured = std::get_if<pioneer::Configured>(&event)) {
    input_.base.watchdog_s = configured->config.watchdog_ms / 1000.0;
    input_.base.deceleration_mps2 = configured->config.deceleration / 1000.0;
    kinematics_delay_ = std::chrono::milliseconds{configured->config.kinematics_delay_ms};
    spdlog::info("base configured: watchdog_ms={} deceleration_mmps2={} firmware={}", configured->config.watchdog_ms,
                 configured->config.deceleration, configured->config.firmware_version);
  }
  if (const auto* gap = std::get_if<pioneer::Gap>(&event)) {
    spdlog::warn("gap: nothing was sent for {:.2f} s", to_seconds(gap->silent));
    if (gap->silent > kFrozen) gate_.take_service_failure();
  }
}

void BaseService::take_identity(const pioneer::Identity& identity) {
  const auto* known = pioneer::robot_parameters(identity.subclass);
  const bool calibrated = config_.metres_per_count > 0.0 && config_.half_track_per_m > 0.0;
  if (known == nullptr && !calibrated) {
    link_.start_over("unknown robot model \"" + identity.subclass +
                     "\": calibrate it and set metres_per_count and half_track_per_m in base.toml");
    return;
  }
  parameters_ = known != nullptr ? *known : pioneer::RobotParameters{};
  if (config_.metres_per_count > 0.0) parameters_.metres_per_count = config_.metres_per_count;
  if (config_.half_track_per_m > 0.0) parameters_.half_track_per_m = config_.half_track_per_m;
  model_ = identity.subclass;
  odometry_.restart(parameters_);
  input_.base.watchdog_s = input_.base.deceleration_mps2 = 0.0;  // until it says
  spdlog::info("base connected: name={} model={} epoch={}", identity.name, model_, odometry_.state().epoch);
}

void BaseService::take_status(const pioneer::StatusReceived& status) {
  const auto& sip = status.sip;
  const Time measured = mission_.now() - (timer_.now() - status.first_byte) - kinematics_delay_;
  const auto& odometry = odometry_.take(sip, status.first_byte);
  if (odometry.jumped) spdlog::warn("odometry jumped: step left out, jumps={}", odometry_.jumps());

  auto& base = input_.base;
  const bool touched = sip.left_stalled || sip.right_stalled || sip.front_bumpers != 0 || sip.rear_bumpers != 0 ||
                       sip.stop_pressed() || odometry.jumped;
  contact_ = contact_ || touched;
  base.motors_enabled = sip.motors_enabled();
  base.estop_pressed = sip.stop_pressed();
  base.left_stalled = sip.left_stalled;
  base.right_stalled = sip.right_stalled;
  base.front_bumpers = sip.front_bumpers;
  base.rear_bumpers = sip.rear_bumpers;
  base.battery_v = sip.battery_v();
  base.odom_from_base = odometry.odom_from_base;
  base.odometry_epoch = odometry.epoch;
  base.odometry_jumped = base.odometry_jumped || odometry.jumped;
  base.measured = {odometry.velocity.forward_mps, odometry.velocity.turn_rate_radps};

  odometry_writer_.write(to_message(odometry, robot_, measured));
  if (!sip.sonar.empty()) sonar_writer_.write(sonar_message(sip, parameters_, robot_, measured));
}

void BaseService::cycle() {
  const Time now = timer_.now();
  input_.base.connected = link_.session().is_running();
  if (!input_.base.connected) input_.base.motors_enabled = false;
  feed_.feed(gate_, input_.base.odom_from_base, now);
  feed_.complete(input_, now);
  input_.other_base = health_.is_doubled();

  const safety::GateDecision decision = gate_.step(input_, now);
  input_.base.odometry_jumped = false;
  link_.session().drive(decision.motion.forward_mps, decision.motion.turn_rate_radps);
  link_.session().step(now);
  link_.flush();

  mark_driving(input_.base.motors_enabled);
  publish_status(decision, now);
  log_changes(decision);
}

void BaseService::publish_status(const safety::GateDecision& decision, Time now) {
  const msg::BaseStatus status = to_message({input_.base, decision, model_}, robot_, mission_.now());
  if (now >= next_status_ || !is_same_state(status, last_status_)) {
    status_writer_.write(status);
    last_status_ = status;
    next_status_ = now + kStatusPeriod;
  }
  if (!input_.base.connected) {
    health_.step(model_.empty() ? msg::HEALTH_STARTING : msg::HEALTH_FAILED, link_.trouble());
  } else if (decision.battery_warning) {
    health_.step(msg::HEALTH_DEGRADED, "the battery is low: finish soon and charge");
  } else if (decision.causes.test(index_of(safety::Cause::TwoCommanders))) {
    const auto& rule = safety::rule_of(safety::Cause::TwoCommanders);
    health_.step(msg::HEALTH_OK, "", {{std::string{rule.fault_id}, std::string{rule.message}}});
  } else {
    health_.step(msg::HEALTH_OK);
  }
}

void BaseService::log_changes(const safety::GateDecision& decision) {
  if (link_.trouble() != last_trouble_) {
    last_trouble_ = link_.trouble();
    if (!last_trouble_.empty()) spdlog::warn("{}; trying again", last_trouble_);
  }
  for (const auto& note : feed_.take_notes()) spdlog::info("{}", note);
  // An obstacle that limits comes and goes with every turn of the path.
  safety::Causes causes = decision.causes;
  causes.reset(index_of(safety::Cause::ObstacleAhead));
  if (causes == last_causes_) return;
  for (const auto& rule : safety::kStopRules) {
    if (!causes.test(index_of(rule.cause)) || last_causes_.test(index_of(rule.cause))) continue;
    spdlog::warn("stopped: {} fault_id={} {}", rule.message, rule.fault_id,
                 rule.resume == safety::Resume::Latched ? "until somebody resumes" : "until it is over");
  }
  if (causes.none()) spdlog::info("all causes to stop are gone: resume_in_s={:.1f}", decision.resume_in_s);
  last_causes_ = causes;
}

}  // namespace tandem
