#include "services/localization/localization_service.hpp"

#include <spdlog/spdlog.h>

#include "services/localization/localization_messages.hpp"
#include "services/mapping/map_messages.hpp"

namespace tandem {
namespace {

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
      health_(bus, site, "localization") {}

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
  localizer_.emplace(map_, config_);
  spdlog::info("map taken: id={} sha256={}", received->message.map_id(), received->message.sha256());
}

void LocalizationService::forget_after_restart() {
  if (clock_.epoch() == epoch_) return;
  epoch_ = clock_.epoch();
  if (localizer_) localizer_.emplace(map_, config_);
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
      if (const auto sample = from_message(next->message)) localizer_->add_odometry(*sample);
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
  const auto result = scan ? localizer_->add_scan(*scan) : std::nullopt;
  if (result) {
    poses_.write(to_message(*result, robot_));
  } else if (lockstep_) {
    poses_.write(no_pose(from_stamp_ns(message.stamp_ns()), robot_));
  }
  if (result && result->status != logged_) {
    spdlog::info("localization is {}: agreement={:.2f} x={:.2f} y={:.2f}", name_of(result->status), result->agreement,
                 result->map_from_base.x, result->map_from_base.y);
    logged_ = result->status;
  }
}

void LocalizationService::report() {
  if (!localizer_) {
    health_.step(msg::HEALTH_STARTING, "waiting for the map: is tandem-map-server running on this host?");
  } else if (!localizer_->is_started()) {
    health_.step(msg::HEALTH_STARTING, "waiting for a start pose: place the robot on the phone's map");
  } else if (logged_ == LocalizationStatus::Lost) {
    health_.step(msg::HEALTH_DEGRADED, "lost: scans do not fit the map");
  } else {
    health_.step(msg::HEALTH_OK);
  }
}

}  // namespace tandem
