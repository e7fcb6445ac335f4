#pragma once

#include <optional>
#include <string>

#include "services/bus/bus.hpp"
#include "services/bus/events.hpp"
#include "services/cli/teleop/teleop_view.hpp"

namespace tandem::cli {

/// An operator's line to the base of this host: velocities and resumes out, what the base says in. The safety gate
/// stands at the other end, and brakes if anybody else commands at the same time.
class TeleopLine {
 public:
  TeleopLine(bus::Bus& bus, const SiteConfig& site);

  /// Reads what came; to be called ten times a second or more.
  void step();
  /// Who else drives the robot or is about to, with the remedy; empty if nobody does.
  [[nodiscard]] const std::string& rival() const { return rival_; }
  /// Fills in all of `view` that the base tells.
  void describe(TeleopView& view) const;
  /// True once the base's service has said anything.
  [[nodiscard]] bool has_base() const { return base_.newest().has_value(); }

  void drive(const Twist2& velocity);
  /// Asks for motion after a stop, as somebody who held a button for `held_s`.
  void resume(double held_s);

 private:
  template <typename Message, typename PubSubType>
  using Latest = bus::Latest<Message, PubSubType>;

  bus::Bus& bus_;
  std::string robot_;
  bus::Writer<msg::VelocityCommand, msg::VelocityCommandPubSubType> commands_;
  bus::InOrder<msg::VelocityCommand, msg::VelocityCommandPubSubType> heard_;
  bus::EventSender<msg::ResumeRequest, msg::ResumeRequestPubSubType> resumes_;
  Latest<msg::BaseStatus, msg::BaseStatusPubSubType> base_;
  Latest<msg::Odometry, msg::OdometryPubSubType> odometry_;
  Latest<msg::SessionState, msg::SessionStatePubSubType> sessions_;
  std::uint64_t sequence_number_ = 0;
  std::string rival_;
  std::string resume_id_;
};

}  // namespace tandem::cli
