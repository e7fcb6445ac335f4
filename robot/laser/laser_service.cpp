#include "robot/laser/laser_service.hpp"

#include <spdlog/spdlog.h>

#include "robot/laser/laser_messages.hpp"

namespace tandem {
namespace {

constexpr Duration kRemembersDamage = std::chrono::seconds{5};

msg::HealthState health_of(LaserCondition::State state) {
  switch (state) {
    case LaserCondition::State::Opening:
      return msg::HEALTH_STARTING;
    case LaserCondition::State::Streaming:
      return msg::HEALTH_OK;
    case LaserCondition::State::Lost:
      break;
  }
  return msg::HEALTH_FAILED;
}

}  // namespace

LaserService::LaserService(const LaserConfig& config, const SiteConfig& site, bus::Bus& bus, Clock& timer,
                           const Clock& mission)
    : driver_(config, timer, mission),
      timer_(timer),
      robot_(site.robot),
      base_from_laser_(config.base_from_laser()),
      scans_(bus.writer(topic::kScan)),
      health_(bus, site, "laser") {}

void LaserService::step() {
  for (const LaserReading& reading : driver_.step()) {
    scans_.write(to_message(reading, robot_, base_from_laser_, sequence_number_++));
  }
  report();
}

void LaserService::report() {
  const LaserCondition& condition = driver_.condition();
  if (condition.state != logged_.state || (condition != logged_ && condition.state == LaserCondition::State::Lost)) {
    if (condition.state == LaserCondition::State::Streaming)
      spdlog::info("laser streams: sensor={}", driver_.identity());
    if (condition.state == LaserCondition::State::Lost) spdlog::warn("no laser: {}", condition.reason);
    logged_ = condition;
  }
  const std::string complaint = complaint_now();
  if (complaint.empty() != complaint_.empty()) {
    if (!complaint.empty()) spdlog::warn("laser in doubt: {}", complaint);
    complaint_ = complaint;
  }
  if (condition.state == LaserCondition::State::Streaming && !complaint.empty()) {
    health_.step(msg::HEALTH_DEGRADED, complaint);
  } else {
    health_.step(health_of(condition.state), condition.reason);
  }
}

std::string LaserService::complaint_now() {
  const Time now = timer_.now();
  if (driver_.damaged() != damaged_) last_damage_ = now;
  damaged_ = driver_.damaged();
  if (auto complaint = driver_.complaint(); !complaint.empty()) return complaint;
  if (last_damage_ && now - *last_damage_ < kRemembersDamage) return "damaged replies: check the cable and its supply";
  return "";
}

}  // namespace tandem
