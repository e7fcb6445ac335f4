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
  const Time now = timer_.now();
  if (driver_.damaged() != damaged_) {
    if (!was_damaged_) spdlog::warn("laser replies damaged: count={}", driver_.damaged());
    damaged_ = driver_.damaged();
    last_damage_ = now;
    was_damaged_ = true;
  }
  if (now - last_damage_ > kRemembersDamage) was_damaged_ = false;
  if (condition.state == LaserCondition::State::Streaming && was_damaged_) {
    health_.step(msg::HEALTH_DEGRADED, "damaged replies within the last seconds: check cable and supply");
  } else {
    health_.step(health_of(condition.state), condition.reason);
  }
}

}  // namespace tandem
