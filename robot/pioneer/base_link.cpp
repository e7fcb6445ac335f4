#include "robot/pioneer/base_link.hpp"

#include <cmath>

#include "robot/pioneer/gated_base.hpp"

namespace tandem {

BaseLink::BaseLink(const BaseConfig& config, Clock& timer)
    : config_(config), timer_(timer), session_(session_config(config)) {
  if (config_.baud_rates.empty()) config_.baud_rates.push_back(9600);
}

std::string BaseLink::device_name() const {
  if (config_.device.starts_with("tcp:")) return config_.device;
  return config_.device + " at " + std::to_string(std::lround(config_.baud_rates[baud_])) + " baud";
}

Duration BaseLink::transmission_time(std::size_t bytes) const {
  constexpr double kBitsPerByte = 10.0;  // with start and stop
  if (config_.device.starts_with("tcp:")) return Duration::zero();
  return from_seconds(static_cast<double>(bytes) * kBitsPerByte / config_.baud_rates[baud_]);
}

void BaseLink::open() {
  const LinkOptions options{.baud_rate = static_cast<int>(config_.baud_rates[baud_]),
                            .connect_timeout = from_seconds(0.5)};
  OpenedLink opened = open_byte_link(config_.device, options);
  if (!opened.link) {
    trouble_ = "no answer from " + opened.failure;
    next_attempt_ = timer_.now() + back_off_.next();
    return;
  }
  link_ = std::move(opened.link);
  session_.link_opened(timer_.now());
}

void BaseLink::start_over(const std::string& why) {
  flush();
  link_.reset();
  session_.link_closed();
  trouble_ = why;
  next_attempt_ = timer_.now() + back_off_.next();
}

void BaseLink::flush() {
  const pioneer::Bytes bytes = session_.take_output();
  if (link_ && !bytes.empty()) link_->write(bytes);
}

void BaseLink::receive(Duration timeout) {
  const auto bytes = link_->read(timeout);
  session_.receive(bytes, timer_.now());
  if (!link_->is_open()) start_over(link_->failure());
}

std::vector<pioneer::SessionEvent> BaseLink::exchange(Duration timeout) {
  if (!link_ && timer_.now() >= next_attempt_) open();
  flush();
  if (link_) {
    receive(timeout);
    flush();
  } else {
    timer_.wait_until(timer_.now() + timeout, nullptr);
  }
  auto events = session_.take_events();
  for (const auto& event : events) {
    if (const auto* gave_up = std::get_if<pioneer::GaveUp>(&event)) {
      start_over("no answer from " + device_name() + ": " + gave_up->why +
                 "; is the robot switched on, and is this its port?");
      baud_ = (baud_ + 1) % config_.baud_rates.size();
    }
    // A link that broke has said so already, with the device's name.
    if (const auto* lost = std::get_if<pioneer::Lost>(&event); lost && link_) {
      trouble_ = "the robot was lost: " + lost->why;
    }
  }
  if (session_.is_running()) {
    trouble_.clear();
    back_off_.reset();
  }
  return events;
}

void BaseLink::shut_down() {
  session_.begin_shutdown(timer_.now());
  flush();
  const Time latest = timer_.now() + from_seconds(0.5);
  while (link_ && !session_.is_closed() && timer_.now() < latest) {
    receive(from_seconds(0.02));
    session_.step(timer_.now());
  }
  flush();
  if (link_) timer_.wait_until(timer_.now() + from_seconds(0.2), nullptr);  // CLOSE leaves before the port does
  link_.reset();
}

}  // namespace tandem
