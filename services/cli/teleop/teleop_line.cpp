#include "services/cli/teleop/teleop_line.hpp"

#include "services/bus/stop_reasons.hpp"

namespace tandem::cli {
namespace {

constexpr Duration kFreshStatus = std::chrono::milliseconds{1500};
constexpr Duration kFreshOdometry = std::chrono::milliseconds{500};

}  // namespace

TeleopLine::TeleopLine(bus::Bus& bus, const SiteConfig& site)
    : bus_(bus),
      robot_(site.robot),
      commands_(bus.writer(topic::kVelocityCommand)),
      heard_(bus.in_order(topic::kVelocityCommand)),
      resumes_(bus, topic::kResumeRequest),
      base_(bus.latest(topic::kBaseStatus)),
      odometry_(bus.latest(topic::kOdometry)),
      sessions_(bus.latest(topic::kSession)) {}

void TeleopLine::step() {
  resumes_.step();
  for (const auto& session : sessions_.each()) {
    if (session.message.robot() == robot_ && session.writer_alive && session.message.phase() == msg::SESSION_RUNNING) {
      rival_ = "a search is running, and the robot follows its plans: end the session first";
    }
  }
  for (const auto& command : heard_.take()) {
    if (command.message.robot() != robot_ || command.writer == commands_.raw().id()) continue;
    rival_ = "\"" + command.message.commander() + "\" is driving the robot: let it come to its end, or end it first";
  }
}

void TeleopLine::describe(TeleopView& view) const {
  const Time now = bus_.clock().now();
  view.resume_answer.clear();
  if (!resume_id_.empty() && resumes_.outcome(resume_id_).state == bus::EventOutcome::State::Refused) {
    view.resume_answer = resumes_.outcome(resume_id_).reason;
  }
  view.base.reset();
  if (const auto status = base_.newest(); status && now - status->received < kFreshStatus) {
    const msg::BaseStatus& base = status->message;
    view.base = {.connected = base.connected(),
                 .motors_enabled = base.motors_enabled(),
                 .battery_v = base.battery_v(),
                 .speed_limit_mps = base.speed_limit_mps(),
                 .stopped_by = {},
                 .latched = base.latched(),
                 .resume_in_s = base.resume_in_s(),
                 .model = base.model()};
    for (const auto reason : base.stop_reasons()) view.base->stopped_by.push_back(bus::words_of(reason));
  }
  view.measured.reset();
  if (const auto odometry = odometry_.newest(); odometry && now - odometry->received < kFreshOdometry) {
    const auto& velocity = odometry->message.velocity();
    view.measured = Twist2{velocity.forward_mps(), velocity.left_mps(), velocity.turn_rate_radps()};
  }
}

void TeleopLine::drive(const Twist2& velocity) {
  msg::VelocityCommand command;
  command.robot(robot_);
  command.stamp_ns(to_stamp_ns(bus_.clock().now()));
  command.sequence_number(++sequence_number_);
  command.commander("teleop");
  command.forward_mps(velocity.forward_mps);
  command.turn_rate_radps(velocity.turn_rate_radps);
  commands_.write(command);
}

void TeleopLine::resume(double held_s) {
  msg::ResumeRequest request;
  request.robot(robot_);
  request.id(bus::new_event_id("teleop", bus_.clock()));
  request.stamp_ns(to_stamp_ns(bus_.clock().now()));
  request.who("teleop");
  request.held_ms(static_cast<std::uint32_t>(1000.0 * held_s));
  resumes_.send(request);
  resume_id_ = request.id();
}

}  // namespace tandem::cli
