#include "services/cli/teleop_command.hpp"

#include <CLI/CLI.hpp>
#include <csignal>
#include <memory>
#include <stdexcept>
#include <tuple>

#include "services/cli/command.hpp"
#include "services/cli/host_bus.hpp"
#include "services/cli/live_terminal.hpp"
#include "services/cli/teleop/gamepad.hpp"
#include "services/cli/teleop/gamepad_state.hpp"
#include "services/cli/teleop/operator_keys.hpp"
#include "services/cli/teleop/teleop_line.hpp"

namespace tandem::cli {
namespace {

struct TeleopOptions {
  HostOptions host;
  TeleopSpeeds speeds;
  std::string gamepad;
  GamepadLayout layout;
};

constexpr Duration kPeriod = std::chrono::milliseconds{50};
constexpr Duration kDrawPeriod = std::chrono::milliseconds{100};
constexpr Duration kListen = std::chrono::seconds{1};     // longer than anybody who drives is silent
constexpr Duration kPatience = std::chrono::seconds{10};  // for the base's first word

/// Keyboard and gamepad, as one operator: whoever holds the gamepad's drive button has it.
class Operator {
 public:
  explicit Operator(const TeleopOptions& options) : keys_(options.speeds), pad_state_(options.layout, options.speeds) {
    if (!options.gamepad.empty()) pad_ = std::make_unique<Gamepad>(options.gamepad);
  }

  void take(std::string_view typed, Time now) {
    keys_.take(typed, now);
    if (!pad_) return;
    for (const auto& event : pad_->events()) pad_state_.take(event, now);
  }
  [[nodiscard]] Twist2 wanted(Time now) const {
    const auto by_pad = pad_ && pad_->is_there() ? pad_state_.wanted(now) : std::nullopt;
    return by_pad.value_or(keys_.wanted(now));
  }
  [[nodiscard]] std::optional<double> take_resume() {
    const auto by_pad = pad_state_.take_resume();
    const auto by_key = keys_.take_resume();
    return by_pad ? by_pad : by_key;
  }
  [[nodiscard]] bool wants_to_quit() const { return keys_.wants_to_quit(); }
  void describe(TeleopView& view, Time now) const {
    view.speeds = keys_.speeds();
    view.wanted = wanted(now);
    if (!pad_) return;
    view.gamepad = pad_->is_there() ? printable(pad_->name()) + ": hold its shoulder button to drive"
                                    : "was unplugged: plug it in and start anew";
  }

 private:
  OperatorKeys keys_;
  GamepadState pad_state_;
  std::unique_ptr<Gamepad> pad_;
};

/// Waits for the base, and long enough to hear whoever drives it.
void wait_for_base(TeleopLine& line, bus::Bus& bus) {
  const Time began = bus.clock().now();
  const auto passed = [&] { return bus.clock().now() - began; };
  while (!stop_requested() && (passed() < kListen || (!line.has_base() && passed() < kPatience))) {
    bus.wait(kPeriod);
    line.step();
  }
  if (!line.rival().empty()) throw std::runtime_error(line.rival());
  if (!line.has_base() && !stop_requested()) {
    throw std::runtime_error(
        "no base is on this host: teleop runs on the robot's own, beside tandem-base "
        "(systemctl status tandem-base), and in its domain (--domain)");
  }
}

void drive(TeleopLine& line, Operator& person, bus::Bus& bus) {
  LiveTerminal terminal;
  TeleopView view;
  for (Time next_draw{}; !stop_requested() && !person.wants_to_quit() && line.rival().empty();) {
    const auto typed = terminal.keys(kPeriod);
    if (!typed) return;
    const Time now = bus.clock().now();
    person.take(*typed, now);
    line.step();
    if (!line.rival().empty()) return;
    line.drive(person.wanted(now));
    if (const auto held_s = person.take_resume()) line.resume(*held_s);
    if (now < next_draw) continue;
    next_draw = now + kDrawPeriod;
    person.describe(view, now);
    line.describe(view);
    terminal.draw(lines_of(view));
  }
}

void run(const TeleopOptions& options) {
  if (!LiveTerminal::is_there()) throw WrongUse("teleop needs a terminal: its keys drive, its screen shows the robot");
  std::ignore = stop_requested();  // from now on Ctrl-C ends it in order
  std::signal(SIGHUP, SIG_IGN);    // so does a terminal that goes: its keys then end
  Operator person{options};
  bus::Bus bus{bus::host_domain(site_of(options.host), "teleop")};
  TeleopLine line{bus, site_of(options.host)};
  wait_for_base(line, bus);
  drive(line, person, bus);
  constexpr int kLastWords = 3;  // one may be lost, and silence while driving is a fault
  for (int i = 0; i < kLastWords; ++i) {
    line.drive({});
    bus.wait(kPeriod);
  }
  if (!line.rival().empty()) throw std::runtime_error(line.rival());
}

}  // namespace

void add_teleop_command(CLI::App& tandem) {
  const auto options = std::make_shared<TeleopOptions>();
  CLI::App* command =
      add_command(tandem, "teleop",
                  "Drive the robot by keyboard or gamepad, on its own host and through the safety gate; "
                  "nobody else may drive it meanwhile",
                  "tandem teleop --gamepad /dev/input/js0");
  command->add_option("--speed", options->speeds.forward_mps, "Speed while a key is held [m/s]")
      ->check(CLI::Range(0.05, 0.7))
      ->capture_default_str();
  command->add_option("--turn-rate", options->speeds.turn_rate_radps, "Turn rate while a key is held [rad/s]")
      ->check(CLI::Range(0.05, 1.0))
      ->capture_default_str();
  command->add_option("--gamepad", options->gamepad, "Joystick device, beside the keyboard: /dev/input/js0");
  const auto number = [&](const char* name, int& value, const char* what) {
    command->add_option(name, value, what)->check(CLI::Range(0, 31))->capture_default_str();
  };
  number("--forward-axis", options->layout.forward_axis, "Axis of the gamepad that drives ahead and back");
  number("--turn-axis", options->layout.turn_axis, "Axis of the gamepad that turns");
  number("--drive-button", options->layout.drive_button, "Button of the gamepad that must be held to drive");
  number("--resume-button", options->layout.resume_button, "Button of the gamepad that resumes, held for a second");
  command->add_option("--config", options->host.config_folder, "Folder with site.toml")->capture_default_str();
  command->add_option("--domain", options->host.domain, "DDS domain, instead of the site's");
  command->callback([options] { run(*options); });
}

}  // namespace tandem::cli
