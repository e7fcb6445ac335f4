#include "services/simulator/simulator_messages.hpp"

namespace tandem::simulator {
namespace {

msg::TrueAgent agent_message(const TrueBody& body, const std::string& id) {
  msg::Pose pose;
  pose.x(body.map_from_body.x);
  pose.y(body.map_from_body.y);
  pose.heading(body.map_from_body.heading);
  msg::Velocity2 velocity;
  velocity.forward_mps(body.forward_mps);
  velocity.turn_rate_radps(body.turn_rate_radps);
  msg::TrueAgent agent;
  agent.id(id);
  agent.map_from_agent(pose);
  agent.velocity(velocity);
  return agent;
}

}  // namespace

msg::GroundTruth ground_truth_message(const Simulation& simulation, const std::string& robot, const std::string& agent,
                                      Time now) {
  msg::GroundTruth truth;
  truth.stamp_ns(to_stamp_ns(now));
  truth.robots().push_back(agent_message(simulation.robot(), robot));
  for (const auto& person : simulation.people()) {
    truth.people().push_back(agent_message(person, person.id == "person" ? agent : person.id));
  }
  int number = 0;
  for (const auto& token : simulation.scene().tokens_in_map) {
    msg::Point2 point;
    point.x(token.x());
    point.y(token.y());
    msg::TrueObject object;
    object.id("token" + std::to_string(++number));
    object.position_in_map(point);
    object.seen_by_person(simulation.seen_by_person());
    truth.objects().push_back(object);
  }
  const WheelSpeeds wheels = simulation.wheels();
  truth.left_wheel_mps(wheels.left_mps);
  truth.right_wheel_mps(wheels.right_mps);
  truth.collisions(static_cast<std::uint32_t>(simulation.collisions()));
  return truth;
}

}  // namespace tandem::simulator
