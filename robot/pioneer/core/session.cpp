#include "robot/pioneer/core/session.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "services/common/angle.hpp"

namespace tandem::pioneer {
namespace {

using std::chrono::milliseconds;
constexpr Duration kReplyPatience = milliseconds{500};
constexpr Duration kShortDrain = milliseconds{100};
constexpr Duration kLongDrain = milliseconds{400};  ///< a controller still open sends on for a while
constexpr Duration kOpenPatience = milliseconds{1500};
constexpr Duration kStatusPatience = milliseconds{1000};
constexpr Duration kGap = milliseconds{400};
constexpr Duration kPulsePeriod = milliseconds{200};
constexpr Duration kEnablePeriod = milliseconds{500};
constexpr Duration kConfigPatience = milliseconds{1000};
constexpr Duration kClosePause = milliseconds{100};
constexpr int kAttempts = 4;
constexpr int kConfigRequests = 5;
constexpr std::size_t kFrameBytes = 6;

}  // namespace

void Session::send(const Bytes& bytes) {
  output_.insert(output_.end(), bytes.begin(), bytes.end());
}

Bytes Session::take_output() {
  return std::exchange(output_, {});
}

std::vector<SessionEvent> Session::take_events() {
  return std::exchange(events_, {});
}

void Session::stand_still() {
  send(command(Command::Velocity, 0));
  send(command(Command::TurnRate, 0));
  turn_remainder_degps_ = 0.0;
}

void Session::link_opened(Time now) {
  receiver_.clear();
  output_.clear();
  attempts_ = 0;
  last_trouble_ = "no answer";
  start_syncing(now);
}

void Session::link_closed() {
  if (state_ == State::Running) events_.push_back(Lost{"the link was closed"});
  state_ = State::Closed;
  forward_mps_ = turn_rate_radps_ = 0.0;
}

void Session::start_syncing(Time now) {
  state_ = State::Syncing;
  stage_ = 0;
  deadline_ = now + kReplyPatience;
  ++attempts_;
  stand_still();  // a controller that is still open takes SYNC0 for a pulse
  send(command(Command::Pulse));
}

void Session::try_again(Duration drain, Time now) {
  if (attempts_ >= kAttempts) {
    give_up(last_trouble_);
    return;
  }
  state_ = State::Draining;
  deadline_ = now + drain;
}

void Session::give_up(const std::string& why) {
  state_ = State::Closed;
  send(command(Command::Close));  // a connection left open would not answer the next time either
  events_.push_back(GaveUp{why});
}

void Session::receive(std::span<const std::uint8_t> bytes, Time now) {
  receiver_.push(bytes, now);
  while (const auto packet = receiver_.next()) take_packet(*packet, now);
}

void Session::take_packet(const Packet& packet, Time now) {
  switch (state_) {
    case State::Syncing:
      take_sync_reply(packet, now);
      return;
    case State::Opening:
    case State::Running:
      if (const auto sip = decode_sip(packet)) take_status(*sip, packet, now);
      if (const auto config = decode_config(packet)) {
        configured_ = true;
        if (config->has_gyro == 1) send(command(Command::Gyro, 1));
        events_.push_back(Configured{*config});
      }
      if (auto readings = decode_gyro(packet)) events_.push_back(GyroReceived{std::move(*readings)});
      return;
    case State::Closed:
    case State::Draining:
    case State::ShuttingDown:
      return;
  }
}

void Session::take_sync_reply(const Packet& packet, Time now) {
  if (packet_type::is_sip(packet.number)) {
    last_trouble_ = "it still runs a former connection and does not close it";
    send(command(Command::Close));
    try_again(kLongDrain, now);
    return;
  }
  if (packet.number == packet_type::kSyncCounterOff) {
    last_trouble_ = "its synchronization counter is off";
    try_again(kLongDrain, now);
    return;
  }
  if (packet.number != stage_) {
    last_trouble_ = "it answers the handshake wrongly";
    try_again(kShortDrain, now);
    return;
  }
  if (stage_ < 2) {
    ++stage_;
    deadline_ = now + kReplyPatience;
    send(framed({static_cast<std::uint8_t>(stage_), {}}));
    return;
  }
  const auto identity = decode_identity(packet);
  if (!identity) {
    last_trouble_ = "it does not say what robot it is";
    try_again(kShortDrain, now);
    return;
  }
  events_.push_back(Identified{*identity});
  open(now);
}

void Session::open(Time now) {
  state_ = State::Opening;
  deadline_ = now + kOpenPatience;
  status_ = {};
  forward_mps_ = turn_rate_radps_ = 0.0;
  configured_ = false;
  config_requests_ = 1;
  last_config_request_ = now;
  last_enable_ = Time{};
  send(command(Command::Open, 1));
  stand_still();
  send(command(Command::SetMaxSpeed, config_.max_speed_mmps));
  send(command(Command::SetMaxTurnRate, config_.max_turn_rate_degps));
  send(command(Command::SetTranslationalAcceleration, config_.acceleration_mmps2));
  send(command(Command::SetTranslationalAcceleration, -config_.deceleration_mmps2));
  send(command(Command::SetTurnAcceleration, config_.turn_acceleration_degps2));
  send(command(Command::SetTurnAcceleration, -config_.turn_acceleration_degps2));
  send(command(Command::Sonar, config_.sonar ? 1 : 0));
  send(command(Command::Config));
  last_sent_ = now;
}

void Session::take_status(const Sip& sip, const Packet& packet, Time now) {
  if (state_ == State::Opening) {
    state_ = State::Running;
    attempts_ = 0;
  }
  status_ = sip;
  last_status_ = now;
  if (sip.left_stalled || sip.right_stalled) {  // the firmware would go on by itself when the stall is over
    forward_mps_ = turn_rate_radps_ = 0.0;
    stand_still();
    last_sent_ = now;
  }
  events_.push_back(StatusReceived{sip, packet.first_byte, packet.body.size() + kFrameBytes});
}

void Session::drive(double forward_mps, double turn_rate_radps) {
  const double max_forward = config_.max_speed_mmps / 1000.0;
  const double max_turn = from_degrees(config_.max_turn_rate_degps);
  const bool sane = std::isfinite(forward_mps) && std::isfinite(turn_rate_radps);
  forward_mps_ = sane ? std::clamp(forward_mps, -max_forward, max_forward) : 0.0;
  turn_rate_radps_ = sane ? std::clamp(turn_rate_radps, -max_turn, max_turn) : 0.0;
}

void Session::step(Time now) {
  switch (state_) {
    case State::Closed:
      return;
    case State::Draining:
      if (now >= deadline_) start_syncing(now);
      return;
    case State::Syncing:
      if (now >= deadline_) try_again(Duration::zero(), now);
      return;
    case State::Opening:
      if (now >= deadline_) {
        last_trouble_ = "it sends no status after OPEN";
        try_again(kShortDrain, now);
      }
      return;
    case State::Running:
      step_running(now);
      return;
    case State::ShuttingDown:
      if (now < deadline_) return;
      send(command(Command::Close));
      state_ = State::Closed;
      return;
  }
}

void Session::step_running(Time now) {
  if (now - last_status_ > kStatusPatience) {
    events_.push_back(Lost{"no status for a second"});
    attempts_ = 0;
    last_trouble_ = "no answer";
    receiver_.clear();
    forward_mps_ = turn_rate_radps_ = 0.0;
    start_syncing(now);
    return;
  }
  if (!configured_ && config_requests_ < kConfigRequests && now - last_config_request_ > kConfigPatience) {
    ++config_requests_;
    last_config_request_ = now;
    send(command(Command::Config));
  }
  const bool wants_to_move = forward_mps_ != 0.0 || turn_rate_radps_ != 0.0;
  if (last_sent_ && now - *last_sent_ > kGap) {
    events_.push_back(Gap{now - *last_sent_});
    forward_mps_ = turn_rate_radps_ = 0.0;
    stand_still();
    last_sent_ = now;
  } else if (status_.motors_enabled()) {
    send_velocities();
    last_sent_ = now;
  } else if (wants_to_move && !status_.stop_pressed() && now - last_enable_ > kEnablePeriod) {
    stand_still();  // motors engage with a jerk if a velocity is still set
    send(command(Command::Enable, 1));
    last_enable_ = last_sent_.emplace(now);
  } else if (!last_sent_ || now - *last_sent_ >= kPulsePeriod) {
    send(command(Command::Pulse));
    last_sent_ = now;
  }
}

void Session::send_velocities() {
  if (forward_mps_ == 0.0 && turn_rate_radps_ == 0.0) {
    stand_still();
    return;
  }
  const double wanted_degps = to_degrees(turn_rate_radps_) + turn_remainder_degps_;
  // Towards zero, so that no limit is exceeded by rounding; a hair is added for 30 deg/s that came as 29.9999999.
  const double sent_degps = std::trunc(wanted_degps + std::copysign(1e-6, wanted_degps));
  turn_remainder_degps_ = turn_rate_radps_ == 0.0 ? 0.0 : wanted_degps - sent_degps;
  send(command(Command::Velocity,
               static_cast<int>(std::trunc(1000.0 * forward_mps_ + std::copysign(1e-6, forward_mps_)))));
  send(command(Command::TurnRate, turn_rate_radps_ == 0.0 ? 0 : static_cast<int>(sent_degps)));
}

void Session::begin_shutdown(Time now) {
  if (state_ == State::Closed || state_ == State::ShuttingDown) return;
  forward_mps_ = turn_rate_radps_ = 0.0;
  stand_still();
  send(command(Command::Enable, 0));
  state_ = State::ShuttingDown;
  deadline_ = now + kClosePause;
}

Duration BackOff::next() {
  return std::exchange(wait_, std::min(2 * wait_, kLongest));
}

}  // namespace tandem::pioneer
