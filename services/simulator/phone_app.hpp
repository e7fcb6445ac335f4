#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "gateway/protocol/messages.hpp"
#include "services/simulator/core/simulation.hpp"

namespace tandem::simulator {

/// The app on the simulated phone: turns the gateway's texts into what the screen shows, and presses into texts.
///
/// Each press is a numbered command that is kept, and sent again after a reconnection, until the gateway has it.
class PhoneApp {
 public:
  /// `client` names this phone for ever; `agent` is whose phone it is.
  PhoneApp(std::string client, std::string agent) : client_(std::move(client)), agent_(std::move(agent)) {}

  /// The socket was opened anew: nothing is known until the gateway has said hello.
  void connected_anew();
  /// Takes one text from the gateway; the texts to send in return.
  [[nodiscard]] std::vector<std::string> receive(const std::string& text, Time now);
  /// A press; the texts to send.
  [[nodiscard]] std::vector<std::string> press(const PhoneMessage& message, Time now);

  [[nodiscard]] const Simulation::PhoneView& view() const { return view_; }
  /// Texts from the gateway that were no message.
  [[nodiscard]] int malformed() const { return malformed_; }

 private:
  struct Kept {
    protocol::Command command;
    Time pressed;
  };
  [[nodiscard]] static std::string text_of(const Kept& kept, Time now);
  void show(const protocol::Plan& plan);

  std::string client_;
  std::string agent_;
  std::uint64_t last_sequence_ = 0;
  std::uint64_t last_replan_ = 0;  ///< its sequence number
  std::deque<Kept> outbox_;
  std::optional<Time> last_seen_;
  Simulation::PhoneView view_;
  int malformed_ = 0;
};

}  // namespace tandem::simulator
