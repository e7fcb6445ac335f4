#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gateway/net/https_server.hpp"
#include "gateway/server/command_bridge.hpp"
#include "gateway/server/core/command_ledger.hpp"
#include "gateway/server/core/gateway_config.hpp"
#include "gateway/server/core/rate_limit.hpp"
#include "gateway/server/core/state_pacer.hpp"
#include "gateway/server/core/transit.hpp"
#include "gateway/server/core/two_people.hpp"
#include "gateway/server/front_desk.hpp"
#include "gateway/server/team_view.hpp"
#include "services/bus/health.hpp"

namespace tandem::gateway {

/// Carries messages between the phones and the bus.
class GatewayService {
 public:
  /// `mission_clock` stamps what goes on the bus; `machine_clock` is for tokens, rates and pacing.
  GatewayService(const GatewayConfig& config, const SiteConfig& site, bus::Bus& bus, const Clock& mission_clock,
                 const Clock& machine_clock);

  void step();
  [[nodiscard]] std::uint16_t port() const { return server_.port(); }
  [[nodiscard]] const std::string& participant_link() const { return participant_link_; }

 private:
  struct Phone {
    std::string session;
    Slot slot;
    RateLimit limit;
    int strikes = 0;
    Transit transit{};
    std::string client;  ///< known from its first command
  };
  struct LinkFile {
    Slot slot;
    std::string file;
    bool always = false;  ///< a link is made even if no file is asked for
    bool issued = false;
    std::optional<Time> alone_since;  ///< since when its phone is not here
  };

  void greet(net::SocketId socket, const std::string& session);
  void handle(net::SocketId socket, Phone& phone, const std::string& text);
  void handle(net::SocketId socket, Phone& phone, protocol::Command command);
  /// Why `command` of `phone` is not carried out, for people.
  [[nodiscard]] std::optional<std::string> refusal_of(Phone& phone, const protocol::Command& command);
  [[nodiscard]] bool is_without_robot() const { return session_.mode == "human_human"; }
  /// What the bus says, and what the configuration knows better.
  [[nodiscard]] protocol::Session session_now() const;
  [[nodiscard]] protocol::State state_now() const;
  [[nodiscard]] std::string session_text(const Slot& slot) const;
  [[nodiscard]] static std::string state_text(const protocol::State& state, const Slot& slot);
  void acknowledge(const std::string& client, std::vector<protocol::Result> results);
  void send_to_all(const protocol::ServerMessage& message);
  void show_team();
  void renew_links();

  GatewayConfig config_;
  SiteConfig site_;
  const Clock& machine_clock_;
  std::string epoch_;
  const Clock& mission_clock_;
  FrontDesk desk_;
  net::Certificate certificate_;
  net::HttpsServer server_;
  TeamView team_;
  CommandBridge bridge_;
  bus::HealthReporter health_;
  StatePacer pacer_;
  protocol::Session session_;  ///< as the phones know it
  TwoPeople people_;
  CommandLedger ledger_;
  std::map<net::SocketId, Phone> phones_;
  std::vector<LinkFile> links_;
  std::string participant_link_;
};

}  // namespace tandem::gateway
