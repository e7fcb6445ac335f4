#include "services/simulator/phone.hpp"

#include <spdlog/spdlog.h>

#include <filesystem>
#include <optional>

#include "gateway/net/websocket_client.hpp"
#include "services/common/file_io.hpp"
#include "services/simulator/phone_app.hpp"

namespace tandem::simulator {
namespace {

class GatewayPhone final : public Phone {
 public:
  GatewayPhone(std::string pairing_file, std::string agent)
      : pairing_file_(std::move(pairing_file)), agent_(std::move(agent)) {}

  Simulation::PhoneView view(Time now) override {
    if (!app_) app_.emplace("simulated-phone-" + std::to_string(to_stamp_ns(now)), agent_);
    look_for_link(now);
    if (!client_) return {};
    report_trouble();
    if (client_->connections() != connections_) {
      connections_ = client_->connections();
      app_->connected_anew();
      spdlog::info("phone connected: agent={} connections={}", agent_, connections_);
    }
    for (const auto& text : client_->take()) send(app_->receive(text, now));
    (void)client_->take_binary();
    auto shown = app_->view();
    shown.connected = shown.connected && client_->state() == net::WebSocketClient::State::Connected;
    return shown;
  }

  void press(const PhoneMessage& message, Time now) override {
    if (app_) send(app_->press(message, now));
  }

 private:
  /// Asks for the link twice a second, patiently; a link that is replaced (a new session) pairs again.
  void look_for_link(Time now) {
    if (now < next_look_) return;
    next_look_ = now + std::chrono::milliseconds{500};
    std::error_code error;
    if (!std::filesystem::exists(pairing_file_, error)) return;
    std::string text;
    try {
      text = read_file(pairing_file_);
    } catch (const FileError& unreadable) {
      return;  // just being replaced
    }
    if (text == link_text_) return;
    const auto link = net::parse_pairing_link(text);
    if (!link) return;  // half-written
    link_text_ = text;
    client_.reset();
    connections_ = 0;
    reported_.clear();
    client_ = std::make_unique<net::WebSocketClient>(*link);
    spdlog::info("phone pairs: gateway={}:{}", link->host, link->port);
  }

  void report_trouble() {
    const std::string reason = client_->reason();
    if (reason == reported_) return;
    reported_ = reason;
    if (reason.empty()) return;
    if (client_->state() == net::WebSocketClient::State::Refused) {
      spdlog::warn("phone refused: reason={}; waiting for a new link in {}", reason, pairing_file_);
    } else {
      spdlog::warn("phone without gateway: reason={}; trying again", reason);
    }
  }

  void send(const std::vector<std::string>& texts) {
    for (const auto& text : texts) (void)client_->send(text);  // what is lost is sent again after the next hello
  }

  std::string pairing_file_;
  std::string agent_;
  std::string link_text_;
  Time next_look_{};
  std::optional<PhoneApp> app_;
  std::unique_ptr<net::WebSocketClient> client_;
  std::uint64_t connections_ = 0;
  std::string reported_;  ///< the trouble that was told last
};

}  // namespace

std::unique_ptr<Phone> make_phone(const std::string& pairing_file, const std::string& agent) {
  return std::make_unique<GatewayPhone>(pairing_file, agent);
}

}  // namespace tandem::simulator
