#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/common/random.hpp"
#include "services/common/time.hpp"

namespace tandem::simulator {

/// A team plan as the person sees it on the phone.
struct PhonePlan {
  std::string id;
  std::vector<Eigen::Vector2d> own_path_in_map;  ///< [m]

  friend bool operator==(const PhonePlan&, const PhonePlan&) = default;
};

/// What the person knows at one moment, from the phone and with their own eyes.
struct PhoneUserInput {
  Time now{};
  double dt_s = 0.0;  ///< Since the last call.
  Pose2 map_from_person = {};
  bool walking = false;  ///< Still under way on the route last taken.
  bool connected = false;
  bool computing = false;       ///< The phone shows that a plan is being computed.
  bool search_over = false;     ///< The phone shows that it was found, or time is up.
  bool replan_refused = false;  ///< The phone shows that the last *Replan* came to nothing.
  std::optional<PhonePlan> plan = {};
  std::optional<Eigen::Vector2d> visible_token_in_map = {};  ///< In line of sight and near enough to be seen.
};

enum class PhonePress { MyPose, MyGoal, Replan, Found };

/// One press on the phone.
struct PhoneMessage {
  PhonePress press = PhonePress::Replan;
  std::optional<Eigen::Vector2d> point_in_map;  ///< MyPose, MyGoal, Found [m]
  std::optional<double> heading;                ///< MyPose [rad]
};

/// What the person does.
struct PhoneUserDecision {
  std::vector<PhoneMessage> messages;
  std::optional<std::vector<Eigen::Vector2d>> new_route_in_map;  ///< Walk there from now on; empty: stand still.
  bool found = false;                                            ///< Has seen a token.
};

/// Decides for one simulated person with a phone. Pure: no transport, no clock.
class PhoneUser {
 public:
  virtual ~PhoneUser() = default;
  [[nodiscard]] virtual PhoneUserDecision step(const PhoneUserInput& input, Rng& rng) = 0;
};

}  // namespace tandem::simulator
