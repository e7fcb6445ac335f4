#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/link/byte_link.hpp"
#include "robot/pioneer/base_config.hpp"
#include "robot/pioneer/core/session.hpp"
#include "services/common/clock.hpp"

namespace tandem {

/// Keeps a session with the controller going: opens the device, moves bytes, and starts over after a loss.
class BaseLink {
 public:
  BaseLink(const BaseConfig& config, Clock& timer);

  /// Waits for bytes at most `timeout`; gives what happened. Sends whatever the session has to say.
  [[nodiscard]] std::vector<pioneer::SessionEvent> exchange(Duration timeout);
  /// Sends at once what the session has to say.
  void flush();
  /// Ends this connection and tries again later.
  void start_over(const std::string& why);
  /// Velocity 0, motors off, CLOSE; takes about 0.3 s.
  void shut_down();

  [[nodiscard]] pioneer::Session& session() { return session_; }
  /// How long `bytes` take on a serial line; 0 over the network.
  [[nodiscard]] Duration transmission_time(std::size_t bytes) const;
  /// Why there is no connection, with the remedy; empty while there is one.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }

 private:
  void open();
  void receive(Duration timeout);
  [[nodiscard]] std::string device_name() const;

  BaseConfig config_;
  Clock& timer_;
  pioneer::Session session_;
  pioneer::BackOff back_off_;
  std::optional<ByteLink> link_;
  std::size_t baud_ = 0;
  Time next_attempt_{};
  std::string trouble_ = "connecting";
};

}  // namespace tandem
