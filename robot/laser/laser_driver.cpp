#include "robot/laser/laser_driver.hpp"

#include <algorithm>

#include "robot/laser/core/cola_session.hpp"
#include "robot/laser/core/lms_session.hpp"
#include "robot/laser/core/scip_session.hpp"
#include "robot/link/device.hpp"

namespace tandem {
namespace {

constexpr Duration kWait = std::chrono::milliseconds{20};
constexpr Duration kConnectTimeout = std::chrono::milliseconds{500};

bool is_serial(const LaserConfig& config) {
  return std::holds_alternative<SerialDevice>(parse_device(config.device));
}

/// Rates a serial sensor may have been left at, most likely first.
std::vector<int> baud_rates(const LaserConfig& config) {
  if (config.protocol == "lms2xx") return {9'600, 38'400, 500'000, 19'200};
  return {115'200, 19'200, 57'600, 250'000, 500'000, 750'000};
}

std::unique_ptr<LaserSession> session_of(const LaserConfig& config, Time opened, int baud_rate) {
  const int rate = is_serial(config) ? baud_rate : 0;
  if (config.protocol == "lms2xx") return std::make_unique<LmsSession>(config, opened, rate);
  if (config.protocol == "cola") return std::make_unique<ColaSession>(config, opened);
  return std::make_unique<ScipSession>(config, opened, rate);
}

}  // namespace

LaserDriver::LaserDriver(const LaserConfig& config, Clock& timer, const Clock& mission)
    : config_(config),
      timer_(timer),
      mission_(mission),
      filter_(config),
      reconnection_(baud_rates(config)),
      next_try_(timer.now()) {
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
  LaserSession::Output output = session_->step(bytes, timer_.now());
  if (!output.send.empty()) link_->write(output.send);
  if (output.baud_rate) {
    link_->set_baud_rate(*output.baud_rate);
    reconnection_.switched_to(*output.baud_rate);
  }
  std::vector<LaserReading> readings;
  for (DeviceScan& scan : output.scans) readings.push_back(stamped(std::move(scan), received));

  if (session_->state() == LaserSession::State::Failed) {
    lose(config_.device + ": " + session_->reason());
  } else if (!link_->is_open()) {
    lose(link_->failure());
  } else if (session_->state() == LaserSession::State::Streaming) {
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
  session_ = session_of(config_, timer_.now(), reconnection_.baud_rate());
  device_clock_.reset();
  watch_.reset();
  last_mark_ = Time{};
}

void LaserDriver::lose(std::string reason) {
  if (session_) damaged_before_ += session_->damaged();
  const bool silent = session_ && !session_->was_answered();
  if (session_ && link_->is_open()) link_->write(session_->farewell());
  link_.reset();
  session_.reset();
  reconnection_.failed(silent);
  next_try_ = timer_.now() + reconnection_.delay();
  condition_ = {LaserCondition::State::Lost, std::move(reason)};
}

LaserReading LaserDriver::stamped(DeviceScan scan, Time received) {
  if (!watch_) watch_.emplace(scan.period_s);
  if (scan.clock && !device_clock_) device_clock_.emplace(scan.least_delay, scan.clock_format);
  Time mark = received - scan.least_delay;
  if (scan.clock) {
    mark = device_clock_->mission_time(*scan.clock, received);
  } else {
    mark = std::max(mark, last_mark_ + std::chrono::milliseconds{1});  // several scans in one read
  }
  last_mark_ = mark;
  scan.reading.first_beam = mark + scan.mark_to_first_beam + from_seconds(config_.clock_offset_s);
  watch_->add(scan.reading);
  filter_.apply(scan.reading);
  return std::move(scan.reading);
}

std::string LaserDriver::complaint() const {
  if (session_ && !session_->warning().empty()) return session_->warning();
  if (auto dirt = filter_.complaint(); !dirt.empty()) return dirt;
  return watch_ ? watch_->complaint() : "";
}

void LaserDriver::stop() {
  if (session_ && link_->is_open()) link_->write(session_->farewell());
  link_.reset();
  session_.reset();
}

}  // namespace tandem
