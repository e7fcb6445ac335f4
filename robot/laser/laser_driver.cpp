#include "robot/laser/laser_driver.hpp"

#include <algorithm>

#include "robot/link/device.hpp"

namespace tandem {
namespace {

constexpr Duration kWait = std::chrono::milliseconds{20};
constexpr Duration kConnectTimeout = std::chrono::milliseconds{500};

/// What passes at least from the index mark to the arrival: the turn up to the last step that is read.
Duration least_delay(const scip::SensorParameters& sensor, const scip::ScanRequest& request) {
  return from_seconds(scip::turn_period_s(sensor) * request.last_step / sensor.steps_per_turn);
}

}  // namespace

LaserDriver::LaserDriver(const LaserConfig& config, Clock& timer, const Clock& mission)
    : config_(config), timer_(timer), mission_(mission), next_try_(timer.now()) {
  (void)parse_device(config_.device);  // an unusable name is known at the start
  condition_.reason = "opens " + config_.device;
}

std::vector<LaserReading> LaserDriver::step() {
  if (!link_) {
    const Time now = timer_.now();
    if (now < next_try_) timer_.wait_until(std::min(next_try_, now + kWait), [] { return false; });
    if (timer_.now() >= next_try_) open();
    return {};
  }
  const std::vector<std::uint8_t> bytes = link_->read(kWait);
  const Time received = mission_.now();
  const ScipSession::Output output = session_->step(bytes, timer_.now());
  if (!output.send.empty()) link_->write(output.send);

  std::vector<LaserReading> readings;
  for (const scip::ScanData& scan : output.scans) readings.push_back(stamped(scan, received));

  if (session_->state() == ScipSession::State::Failed) {
    lose(config_.device + ": " + session_->reason());
  } else if (!link_->is_open()) {
    lose(link_->failure());
  } else if (session_->state() == ScipSession::State::Streaming) {
    if (!readings.empty()) reconnection_.succeeded();
    identity_ = session_->identity();
    condition_ = {LaserCondition::State::Streaming, ""};
  } else {
    condition_ = {LaserCondition::State::Opening, config_.device + ": " + session_->reason()};
  }
  return readings;
}

void LaserDriver::open() {
  OpenedLink opened =
      open_byte_link(config_.device, {.baud_rate = reconnection_.baud_rate(), .connect_timeout = kConnectTimeout});
  if (!opened.link) return lose(opened.failure);
  link_ = std::move(opened.link);
  session_.emplace(config_, timer_.now());
  device_clock_.reset();
  watch_.reset();
}

void LaserDriver::lose(std::string reason) {
  if (session_) damaged_before_ += session_->damaged();
  const bool silent = session_ && !session_->was_answered();
  if (link_ && link_->is_open()) link_->write(ScipSession::farewell());
  link_.reset();
  session_.reset();
  reconnection_.failed(silent);
  next_try_ = timer_.now() + reconnection_.delay();
  condition_ = {LaserCondition::State::Lost, std::move(reason)};
}

LaserReading LaserDriver::stamped(const scip::ScanData& scan, Time received) {
  const scip::SensorParameters& sensor = *session_->sensor();
  if (!device_clock_) device_clock_.emplace(least_delay(sensor, scan.request));
  if (!watch_) watch_.emplace(scip::turn_period_s(sensor) * (scan.request.skip + 1));
  const Time index_mark = device_clock_->mission_time(scan.timestamp_ms, received);
  LaserReading reading =
      reading_of(scan, sensor, index_mark + from_seconds(config_.clock_offset_s), config_.range_max_m);
  watch_->add(reading);
  return reading;
}

void LaserDriver::stop() {
  if (link_ && link_->is_open()) link_->write(ScipSession::farewell());
  link_.reset();
  session_.reset();
}

}  // namespace tandem
