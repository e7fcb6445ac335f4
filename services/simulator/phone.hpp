#pragma once

#include <memory>
#include <string>

#include "services/simulator/core/simulation.hpp"

namespace tandem::simulator {

/// The telephone line between a simulated person and the gateway.
class Phone {
 public:
  virtual ~Phone() = default;
  /// What the screen shows now.
  [[nodiscard]] virtual Simulation::PhoneView view(Time now) = 0;
  /// The person presses; kept until the gateway has it.
  virtual void press(const PhoneMessage& message, Time now) = 0;
};

/// A phone that speaks the gateway's HTTPS and WebSocket. It pairs with the link in `pairing_file`, once that is there,
/// and shows what concerns `agent`.
[[nodiscard]] std::unique_ptr<Phone> make_phone(const std::string& pairing_file, const std::string& agent);

}  // namespace tandem::simulator
