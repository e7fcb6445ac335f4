#include "robot/pioneer/base_service.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "robot/pioneer/base_messages.hpp"
#include "services/common/file_io.hpp"

namespace tandem {
namespace {

constexpr Duration kCycle = std::chrono::milliseconds{50};
constexpr Duration kLook = std::chrono::milliseconds{3};  ///< a command or STOP is never left lying for longer
/// Commands come as often as cycles do; the one whose turn is a little late is not overtaken by a cycle without it.
constexpr Duration kLateCommand = std::chrono::milliseconds{10};
constexpr Duration kStatusPeriod = std::chrono::milliseconds{500};

/// Larger than that of any earlier run, so that nobody takes two runs for one.
std::uint32_t first_epoch(Time now) {
  return static_cast<std::uint32_t>(std::chrono::duration_cast<std::chrono::seconds>(now.time_since_epoch()).count());
}

std::vector<safety::HardZone> hard_zones_of(const MapZones& zones) {
  std::vector<safety::HardZone> all;
  for (const auto& area : zones.areas) {
    all.push_back({area.corners_in_map, area.rule == AreaRule::Slow ? area.max_speed_mps : 0.0});
  }
  return all;
}

/// Whether two statuses say the same but for the time, the voltage and the countdown.
bool is_same_state(msg::BaseStatus a, msg::BaseStatus b) {
  a.stamp_ns(b.stamp_ns());
  a.battery_v(b.battery_v());
  a.resume_in_s(b.resume_in_s());
  return a == b;
}

}  // namespace

BaseService::BaseService(const BaseConfig& config, const MapZones& zones, const SiteConfig& site, bus::Bus& bus,
                         Clock& timer, const Clock& mission)
    : config_(config),
      robot_(site.robot),
      timer_(timer),
      mission_(mission),
      link_(config, timer),
      base_(config, hard_zones_of(zones), first_epoch(timer.now())),
      feed_(bus, site, zones.map_sha256),
      odometry_writer_(bus.writer(topic::kOdometry)),
      sonar_writer_(bus.writer(topic::kSonar)),
      status_writer_(bus.writer(topic::kBaseStatus)),
      health_(bus, site, "base") {
  if (!config_.marker_file.empty() && std::filesystem::exists(config_.marker_file)) {
    spdlog::warn("the last run ended while the motors were on: a resume is needed");
    base_.gate().take_service_failure();
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
  const Duration wait = std::clamp<Duration>(next_cycle_ - timer_.now(), Duration::zero(), kLook);
  for (const auto& event : link_.exchange(wait)) take(event);
  const Time now = timer_.now();
  asked_ = feed_.feed(base_.gate(), base_.input().base.odom_from_base, now) || asked_;
  // Not at once where many ask: the line to the controller takes no more.
  const bool answers = asked_ && now >= last_cycle_ + kCycle / 2;
  if (now < next_cycle_ && !base_.is_urgent() && !answers) return;
  cycle();
  next_cycle_ = answers ? now + kCycle + kLateCommand : std::max(next_cycle_ + kCycle, now + kCycle / 2);
  last_cycle_ = now;
  asked_ = false;
}

void BaseService::take(const pioneer::SessionEvent& event) {
  base_.take(event);
  if (!base_.refusal().empty()) link_.start_over(base_.refusal());
  if (const auto* status = std::get_if<pioneer::StatusReceived>(&event)) publish_motion(*status);
  log_event(event);
}

void BaseService::log_event(const pioneer::SessionEvent& event) {
  if (const auto* identified = std::get_if<pioneer::Identified>(&event); identified && base_.refusal().empty()) {
    spdlog::info("base connected: name={} model={} epoch={}", identified->identity.name, base_.model(),
                 base_.odometry().state().epoch);
  }
  if (const auto* configured = std::get_if<pioneer::Configured>(&event)) {
    spdlog::info("base configured: watchdog_ms={} deceleration_mmps2={} firmware={}", configured->config.watchdog_ms,
                 configured->config.deceleration, configured->config.firmware_version);
  }
  if (const auto* gap = std::get_if<pioneer::Gap>(&event)) {
    spdlog::warn("gap: nothing was sent for {:.2f} s", to_seconds(gap->silent));
  }
}

void BaseService::publish_motion(const pioneer::StatusReceived& status) {
  const Time measured = mission_.now() - (timer_.now() - status.first_byte) - base_.kinematics_delay() -
                        link_.transmission_time(status.bytes);
  const auto& odometry = base_.odometry().state();
  if (odometry.jumped) spdlog::warn("odometry jumped: step left out, jumps={}", base_.odometry().jumps());
  odometry_writer_.write(to_message(odometry, robot_, measured));
  if (!status.sip.sonar.empty()) {
    sonar_writer_.write(sonar_message(status.sip, base_.parameters(), robot_, measured));
  }
}

void BaseService::cycle() {
  const Time now = timer_.now();
  feed_.complete(base_.input(), now);
  base_.input().other_base = health_.is_doubled();

  const safety::GateDecision decision = base_.cycle(link_.session(), now);
  link_.flush();

  mark_driving(base_.input().base.motors_enabled);
  publish_status(decision, now);
  log_changes(decision);
}

void BaseService::publish_status(const safety::GateDecision& decision, Time now) {
  const msg::BaseStatus status = to_message({base_.input().base, decision, base_.model()}, robot_, mission_.now());
  if (now >= next_status_ || !is_same_state(status, last_status_)) {
    status_writer_.write(status);
    last_status_ = status;
    next_status_ = now + kStatusPeriod;
  }
  const std::string trouble = diagnosis_.step(
      {base_.input().base, decision, link_.session().receiver().bad_checksums(), config_.gate.deceleration_mps2}, now);
  if (!base_.input().base.connected) {
    health_.step(base_.model().empty() ? msg::HEALTH_STARTING : msg::HEALTH_FAILED, link_.trouble());
  } else if (!trouble.empty()) {
    health_.step(msg::HEALTH_DEGRADED, trouble);
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
