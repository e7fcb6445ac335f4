#include "services/localization/localization_service.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <filesystem>
#include <variant>

#include "services/common/file_io.hpp"
#include "services/localization/core/last_pose.hpp"
#include "services/localization/localization_messages.hpp"
#include "services/mapping/map_messages.hpp"

namespace tandem {
namespace {

constexpr std::size_t kLatencies = 200;
constexpr Duration kSecond = std::chrono::seconds{1};
constexpr Duration kNewTime =
    std::chrono::seconds{2};  ///< A stamp that goes back further is of a time that began anew.

double milliseconds(Duration duration) {
  return 1e3 * to_seconds(duration);
}

const char* name_of(LocalizationStatus status) {
  switch (status) {
    case LocalizationStatus::Ok:
      return "ok";
    case LocalizationStatus::Uncertain:
      return "uncertain";
    case LocalizationStatus::Lost:
      break;
  }
  return "lost";
}

}  // namespace

LocalizationService::LocalizationService(const LocalizationConfig& config, const SiteConfig& site, bus::Bus& bus,
                                         const Clock& clock)
    : config_(config),
      robot_(site.robot),
      lockstep_(bus.pace() == bus::Pace::Lockstep),
      clock_(clock),
      epoch_(clock.epoch()),
      maps_(bus.latest(topic::kMap)),
      odometry_(bus.in_order(topic::kOdometry)),
      scans_(bus.in_order(topic::kScan)),
      hints_(bus, topic::kPoseHint, "localization"),
      poses_(bus.writer(topic::kRobotPose)),
      health_(bus, site, "localization"),
      latency_(kLatencies) {}

void LocalizationService::step() {
  take_map();
  if (!lockstep_) forget_after_restart();
  if (localizer_ || !lockstep_) {
    take_hints();
    // Scans first: whatever odometry came before the last of them is then there too.
    const auto scans = scans_.take();
    const auto odometry = odometry_.take();
    if (localizer_) feed(odometry, scans);
  }
  if (localizer_ && !lockstep_) {
    if (const auto now = localizer_->predicted_now(); now && now->time != published_) publish(*now);
    keep_last_pose();
    report_memory();
  }
  report();
}

void LocalizationService::take_map() {
  const auto received = maps_.take_new();
  if (!received) return;
  auto grid = to_grid(received->message);
  if (!grid) {
    spdlog::error("map refused, its parts do not fit together: id={}", received->message.map_id());
    return;
  }
  if (localizer_ && *grid == map_) return;  // the map server was started again
  map_ = std::move(*grid);
  map_sha256_ = received->message.sha256();
  begin_anew();
  spdlog::info("map taken: id={} sha256={}", received->message.map_id(), map_sha256_);
  if (!lockstep_ && !config_.last_pose_file.empty()) recall(map_sha256_);
}

void LocalizationService::begin_anew() {
  localizer_.emplace(map_, config_);
  known_faults_ = {};
  logged_memory_ = MemoryOutcome::None;
}

void LocalizationService::forget_after_restart() {
  if (clock_.epoch() == epoch_) return;
  epoch_ = clock_.epoch();
  published_ = Time{Duration::min()};
  if (localizer_) begin_anew();
  spdlog::info("time began anew: epoch={}", epoch_);
}

void LocalizationService::take_hints() {
  for (const msg::PoseHint& message : hints_.take()) {
    if (message.robot() != robot_) continue;
    const auto hint = from_message(message);
    if (!hint || !localizer_) {
      hints_.refused(message.id(), hint ? "localization has no map yet" : "not a pose");
      continue;
    }
    localizer_->add_hint(*hint);
    hints_.applied(message.id());
    spdlog::info("pose hint: who={} x={:.2f} y={:.2f} heading={:.2f}", message.who(), hint->map_from_base.x,
                 hint->map_from_base.y, hint->map_from_base.heading);
  }
}

void LocalizationService::feed(const std::vector<Odometry>& odometry, const std::vector<Scan>& scans) {
  auto next = odometry.begin();
  const auto add_next = [&] {
    if (next->message.robot() == robot_) {
      if (const auto sample = from_message(next->message)) {
        localizer_->add_odometry(*sample);
      } else {
        localizer_->add_fault(InputFault::OdometryNotFinite);
      }
    }
    ++next;
  };
  for (const Scan& scan : scans) {
    while (next != odometry.end() && next->received <= scan.received) add_next();
    if (scan.message.robot() == robot_) localize(scan.message);
  }
  while (next != odometry.end()) add_next();
}

void LocalizationService::localize(const msg::LaserScan& message) {
  const auto scan = from_message(message);
  if (!scan) localizer_->add_fault(InputFault::ScanNotFinite);
  const auto result = scan ? localizer_->add_scan(*scan) : std::nullopt;
  if (lockstep_) {
    poses_.write(result ? to_message(*result, robot_) : no_pose(from_stamp_ns(message.stamp_ns()), robot_));
  } else if (result) {
    publish(*result);
  }
  if (result && result->status != logged_) {
    spdlog::info("localization is {}: agreement={:.2f} x={:.2f} y={:.2f}", name_of(result->status), result->agreement,
                 result->map_from_base.x, result->map_from_base.y);
    logged_ = result->status;
  }
}

void LocalizationService::publish(const LocalizationResult& result) {
  if (result.time < published_ && result.time + kNewTime > published_) return;
  poses_.write(to_message(result, robot_));
  published_ = result.time;
  latency_.add(clock_.now() - result.time);
}

void LocalizationService::recall(const std::string& map_sha256) {
  const std::string& file = config_.last_pose_file;
  if (!std::filesystem::exists(file)) {
    spdlog::info("no last pose is kept yet: file={}", file);
    return;
  }
  try {
    const MemoryRule rule{map_sha256, clock_.now(), from_seconds(config_.last_pose_fresh_s),
                          from_seconds(config_.last_pose_max_age_s)};
    const auto memory = memory_of(read_file(file), rule);
    if (const auto* why = std::get_if<std::string>(&memory)) {
      spdlog::warn("last pose not used: {}: file={}", *why, file);
      return;
    }
    const auto& use = std::get<MemoryUse>(memory);
    localizer_->restore(use.pose, use.memory);
    logged_memory_ = MemoryOutcome::Awaited;
    spdlog::info("last pose waits for the first scan to agree: x={:.2f} y={:.2f} heading={:.2f}",
                 use.pose.map_from_base.x, use.pose.map_from_base.y, use.pose.map_from_base.heading);
  } catch (const FileError& error) {
    spdlog::warn("last pose not used: {}", error.what());
  }
}

void LocalizationService::report_memory() {
  const MemoryOutcome outcome = localizer_->memory_outcome();
  if (outcome == logged_memory_) return;
  logged_memory_ = outcome;
  if (outcome == MemoryOutcome::Agreed) spdlog::info("last pose taken: the scan agrees");
  if (outcome == MemoryOutcome::Refused) spdlog::warn("last pose not used: the scan does not agree with it");
}

void LocalizationService::keep_last_pose() {
  const auto& last = localizer_->last_result();
  if (config_.last_pose_file.empty() || !last || last->result.status != LocalizationStatus::Ok) return;
  const Time now = clock_.now();
  if (now < next_keeping_ && next_keeping_ - now <= kSecond) return;
  next_keeping_ = now + kSecond;
  try {
    write_file_atomically(config_.last_pose_file,
                          to_text({last->result.time,
                                   map_sha256_,
                                   {last->result.map_from_base, last->odometry.odom_from_base, last->odometry.epoch}}));
  } catch (const FileError& error) {
    spdlog::warn("last pose is not kept any more: {}", error.what());
    config_.last_pose_file.clear();
  }
}

std::string LocalizationService::fault_text() {
  const auto fault = localizer_->setup_fault();
  if (fault == InputFault::LaserMirrored) {
    return "laser_mirrored: scans fit the map clearly better with left and right exchanged; is the laser upside down?";
  }
  if (fault == InputFault::MapScaleWrong) {
    return fmt::format("map_scale_wrong: scans fit the map clearly better if its lengths are {:.2f} times too long",
                       localizer_->map_scale());
  }
  return new_faults_.empty() ? "" : "bad input in the last second: " + new_faults_;
}

std::string LocalizationService::latency_text() const {
  if (latency_.empty()) return "";
  return fmt::format("poses are sent {:.0f} ms after their stamp (median; 95 %: {:.0f} ms)",
                     milliseconds(latency_.quantile(0.5)), milliseconds(latency_.quantile(0.95)));
}

void LocalizationService::report() {
  if (!localizer_) {
    health_.step(msg::HEALTH_STARTING, "waiting for the map: is tandem-map-server running on this host?");
    return;
  }
  const Time now = clock_.now();
  if (now >= next_second_ || next_second_ - now > kSecond) {
    next_second_ = now + kSecond;
    const std::string before = std::exchange(new_faults_, localizer_->faults().since(known_faults_).text());
    known_faults_ = localizer_->faults();
    if (before.empty() && !new_faults_.empty()) spdlog::warn("bad input: {}", new_faults_);
    latency_shown_ = latency_text();
  }
  if (const std::string fault = fault_text(); !fault.empty()) {
    health_.step(msg::HEALTH_DEGRADED, fault);
  } else if (!localizer_->is_started()) {
    health_.step(msg::HEALTH_STARTING, "waiting for a start pose: place the robot on the phone's map");
  } else if (logged_ == LocalizationStatus::Lost) {
    health_.step(msg::HEALTH_DEGRADED, "lost: scans do not fit the map");
  } else {
    const std::string faults = known_faults_.text();
    health_.step(msg::HEALTH_OK, latency_shown_ + (faults.empty() ? "" : "; bad input so far: " + faults));
  }
}

}  // namespace tandem
