#include "services/navigator/stop_words.hpp"

namespace tandem {

std::string words_of(msg::StopReason reason) {
  switch (reason) {
    case msg::STOP_NONE:
      return "no reason";
    case msg::STOP_NOT_ENABLED:
      return "motors are off";
    case msg::STOP_REQUESTED:
      return "somebody pressed STOP";
    case msg::STOP_ESTOP:
      return "emergency stop";
    case msg::STOP_BUMPER:
      return "bumper";
    case msg::STOP_STALL:
      return "a wheel is blocked";
    case msg::STOP_OBSTACLE:
      return "something is in the way";
    case msg::STOP_STALE_SCAN:
      return "no scan";
    case msg::STOP_BAD_SCAN:
      return "bad scan";
    case msg::STOP_STALE_COMMAND:
      return "velocity commands ceased";
    case msg::STOP_BAD_COMMAND:
      return "bad velocity command";
    case msg::STOP_STALE_POSE:
      return "no pose";
    case msg::STOP_LOST_POSE:
      return "pose lost";
    case msg::STOP_LINK_LOST:
      return "link lost";
    case msg::STOP_BASE_LOST:
      return "the controller does not answer";
    case msg::STOP_ODOMETRY_JUMP:
      return "odometry jumped";
    case msg::STOP_LOW_BATTERY:
      return "low battery";
    case msg::STOP_TWO_COMMANDERS:
      return "two commanders";
  }
  return "unknown reason";
}

}  // namespace tandem
