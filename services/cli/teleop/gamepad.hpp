#pragma once

#include <linux/joystick.h>

#include <string>
#include <vector>

namespace tandem::cli {

/// A gamepad at the kernel's joystick interface, "/dev/input/js0".
class Gamepad {
 public:
  /// Throws std::runtime_error with the remedy if it cannot be opened.
  explicit Gamepad(std::string device);
  ~Gamepad();
  Gamepad(const Gamepad&) = delete;
  Gamepad& operator=(const Gamepad&) = delete;

  /// What happened since the last call; never waits.
  [[nodiscard]] std::vector<js_event> events();
  /// False once it was unplugged.
  [[nodiscard]] bool is_there() const { return is_there_; }
  /// What it calls itself, or its device.
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  int descriptor_;
  bool is_there_ = true;
  std::string name_;
};

}  // namespace tandem::cli
