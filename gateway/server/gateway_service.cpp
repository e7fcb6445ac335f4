#include "gateway/server/gateway_service.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <type_traits>

#include "gateway/net/pairing_link.hpp"
#include "gateway/server/core/permissions.hpp"
#include "gateway/web/web_assets.hpp"
#include "services/common/file_io.hpp"

namespace tandem::gateway {
namespace {

constexpr double kCommandsPerSecond = 20.0;
constexpr double kCommandBurst = 40.0;
constexpr int kStrikes = 3;
constexpr Duration kRenewBefore = from_seconds(60.0);  // a link that is read now can be used for another minute
constexpr Duration kComeBack = from_seconds(30.0);     // a phone that lost its link gets so long
constexpr std::uint16_t kMovedToOtherPhone = 4001;
constexpr std::uint16_t kMalformed = 4002;
constexpr const char* kPartner = "partner";

std::vector<std::string> names_of(const GatewayConfig& config) {
  std::vector<std::string> names{"localhost", "127.0.0.1", "tandem.local"};
  for (const auto& name : config.other_names) names.push_back(name);
  if (std::find(names.begin(), names.end(), config.link_host) == names.end()) names.push_back(config.link_host);
  return names;
}

net::HttpsServer::Options server_options(const GatewayConfig& config) {
  net::HttpsServer::Options options;
  options.address = config.address;
  options.port = static_cast<std::uint16_t>(config.port);
  options.limits.connections_per_address = static_cast<std::size_t>(config.connections_per_address);
  return options;
}

/// Whose phones there are; the second person's only if there is one.
std::vector<Slot> slots_of(const GatewayConfig& config, const SiteConfig& site) {
  using protocol::UserRole;
  std::vector<Slot> slots{{"participant", UserRole::Participant, site.agent, true},
                          {"observer", UserRole::Observer, "", false},
                          {"operator", UserRole::Operator, site.agent, true}};
  if (!config.partner.empty()) slots.push_back({kPartner, UserRole::Participant, config.partner, true});
  return slots;
}

}  // namespace

GatewayService::GatewayService(const GatewayConfig& config, const SiteConfig& site, bus::Bus& bus,
                               const Clock& mission_clock, const Clock& machine_clock)
    : config_(config),
      site_(site),
      machine_clock_(machine_clock),
      epoch_(net::random_hex(8)),
      mission_clock_(mission_clock),
      desk_(names_of(config), slots_of(config, site),
            (std::filesystem::path{config.state_folder} / "sessions").string(), machine_clock),
      certificate_(net::load_or_create_certificate(config.state_folder, names_of(config))),
      server_(server_options(config), certificate_, web_assets(), desk_),
      team_(bus, site),
      bridge_(bus, site, mission_clock),
      health_(bus, site, "gateway"),
      pacer_(from_seconds(1.0 / config.state_rate_hz), from_seconds(1.0)) {
  desk_.open_at(server_.port());
  for (const auto& slot : slots_of(config, site)) {
    const bool participant = slot.name == "participant";
    const std::string& file = participant               ? config.participant_link_file
                              : slot.name == kPartner   ? config.partner_link_file
                              : slot.name == "observer" ? config.observer_link_file
                                                        : config.operator_link_file;
    links_.push_back({slot, file, participant, false, {}});
  }
  renew_links();
}

void GatewayService::step() {
  team_.step();
  for (const auto& event : server_.take()) {
    const auto phone = phones_.find(event.socket);
    switch (event.kind) {
      case net::SocketEvent::Kind::Opened:
        greet(event.socket, event.session);
        break;
      case net::SocketEvent::Kind::Text:
        if (phone != phones_.end()) handle(event.socket, phone->second, event.text);
        break;
      case net::SocketEvent::Kind::Closed:
        if (phone != phones_.end()) spdlog::info("phone gone: slot={}", phone->second.slot.name);
        phones_.erase(event.socket);
        break;
    }
  }
  for (const auto& session : desk_.take_ended()) {
    for (const auto& [socket, phone] : phones_) {
      if (phone.session == session) server_.close(socket, kMovedToOtherPhone, "moved to another phone");
    }
  }
  for (const auto& settled : bridge_.step()) {
    ledger_.settle(settled.client, settled.result);
    acknowledge(settled.client, {settled.result});
  }
  show_team();
  renew_links();
  health_.step(msg::HEALTH_OK);
}

void GatewayService::greet(net::SocketId socket, const std::string& session) {
  const Slot slot = desk_.slot_of(session);
  phones_.insert_or_assign(
      socket, Phone{session, slot, RateLimit{kCommandsPerSecond, kCommandBurst, machine_clock_.now()}, 0, {}, ""});
  spdlog::info("phone connected: slot={} agent={} phones={}", slot.name, slot.agent, phones_.size());
  protocol::Hello hello;
  hello.epoch = epoch_;
  hello.role = slot.role;
  hello.agent = slot.agent.empty() ? site_.agent : slot.agent;
  hello.robot = site_.robot;
  server_.send(socket, protocol::write(protocol::ServerMessage{hello}));
  if (!team_.map().data.empty()) server_.send_latest(socket, "map", team_.map().data);
  if (!team_.plan().data.empty()) server_.send_latest(socket, "plan", team_.plan().data);
  server_.send_latest(socket, "session", session_text(slot));
  if (!team_.sources().data.empty()) server_.send_latest(socket, "sources", team_.sources().data);
  if (!team_.belief().data.empty()) server_.send_latest(socket, "belief", team_.belief().data, true);
  if (pacer_.last()) server_.send_latest(socket, "state", state_text(*pacer_.last(), slot));
  if (team_.found()) server_.send(socket, protocol::write(protocol::ServerMessage{*team_.found()}));
  if (const auto inform = team_.waiting_inform()) {
    server_.send(socket, protocol::write(protocol::ServerMessage{*inform}));
  }
}

void GatewayService::handle(net::SocketId socket, Phone& phone, const std::string& text) {
  const auto parsed = protocol::parse_client_message(text);
  if (const auto* malformed = std::get_if<protocol::Malformed>(&parsed)) {
    spdlog::warn("malformed message: slot={} why={}", phone.slot.name, malformed->reason);
    server_.send(socket, protocol::write(protocol::ServerMessage{protocol::Event{"error", malformed->reason, {}}}));
    if (++phone.strikes >= kStrikes) server_.close(socket, kMalformed, "malformed messages");
    return;
  }
  std::visit(
      [&](const auto& message) {
        using Message = std::decay_t<decltype(message)>;
        if constexpr (std::is_same_v<Message, protocol::Command>) {
          handle(socket, phone, message);
        } else if constexpr (std::is_same_v<Message, protocol::Ping>) {
          (void)phone.transit.late_ms(message.sent_at_ms, machine_clock_.now());
          server_.send_latest(socket, "pong",
                              protocol::write(protocol::ServerMessage{protocol::Pong{message.sent_at_ms}}));
        } else if constexpr (std::is_same_v<Message, protocol::GotIt>) {
          if (phone.slot.agent == site_.agent) team_.got_it(message.id);
        }  // Seen is for the records of a study.
      },
      std::get<protocol::ClientMessage>(parsed));
}

void GatewayService::handle(net::SocketId socket, Phone& phone, protocol::Command command) {
  if (command.sent_at_ms) command.age_ms += phone.transit.late_ms(*command.sent_at_ms, machine_clock_.now());
  phone.client = command.client;
  switch (ledger_.arrive(command.client, command.sequence)) {
    case CommandLedger::Arrival::Duplicate:
      return acknowledge(command.client, ledger_.results_of(command.client));
    case CommandLedger::Arrival::Gap:
      server_.send(socket,
                   protocol::write(protocol::ServerMessage{protocol::Event{
                       "error", "a command before number " + std::to_string(command.sequence) + " is missing", {}}}));
      return acknowledge(command.client, {});
    case CommandLedger::Arrival::New:
      break;
  }
  if (const auto refusal = refusal_of(phone, command)) {
    const protocol::Result result{command.sequence, "refused", *refusal};
    ledger_.settle(command.client, result);
    spdlog::info("command refused: kind={} slot={} id={} why={}", protocol::name_of(command.kind), phone.slot.name,
                 event_id_of(command), *refusal);
    return acknowledge(command.client, {result});
  }
  if (!is_without_robot() || !is_between_people(command.kind)) return bridge_.submit(command, phone.slot.agent);
  bridge_.record(command, phone.slot.agent);
  people_.note(phone.slot.agent, command, mission_clock_.now() - from_seconds(command.age_ms / 1000.0));
  const protocol::Result result{command.sequence, "applied", ""};
  ledger_.settle(command.client, result);
  acknowledge(command.client, {result});
}

std::optional<std::string> GatewayService::refusal_of(Phone& phone, const protocol::Command& command) {
  const bool is_running = session_.phase == "running";
  if (auto refusal = gateway::refusal_of(phone.slot.role, command.kind, is_running)) return refusal;
  if (auto refusal = gateway::refusal_of(command)) return refusal;
  if (command.point_in_map && !team_.is_on_map(*command.point_in_map)) return "outside the map";
  for (const auto& corner : command.drawing ? command.drawing->outline : std::vector<protocol::Point>{}) {
    if (!team_.is_on_map(corner)) return "outside the map";
  }
  const bool is_stop = command.kind == protocol::CommandKind::Stop;
  if (!is_stop && !phone.limit.allows(machine_clock_.now())) return "too many at once";
  const bool is_record =
      command.kind == protocol::CommandKind::Reminder || command.kind == protocol::CommandKind::Layer;
  if (is_without_robot() && !is_stop && !is_record && !is_between_people(command.kind)) {
    return "there is no robot in this search";
  }
  return std::nullopt;
}

protocol::Session GatewayService::session_now() const {
  protocol::Session session = team_.session();
  if (!config_.mode.empty()) session.mode = config_.mode;
  if (!config_.reminder.empty()) session.reminder.kind = config_.reminder;
  session.reminder.threshold_ms = 1000.0 * config_.reminder_threshold_s;
  session.reminder.factor = config_.reminder_factor;
  session.reminder.floor_ms = 1000.0 * config_.reminder_floor_s;
  return session;
}

std::string GatewayService::session_text(const Slot& slot) const {
  protocol::Session session = session_;
  if (slot.name == kPartner) session.reminder.kind = config_.partner_reminder;
  return protocol::write(protocol::ServerMessage{session});
}

std::string GatewayService::state_text(const protocol::State& state, const Slot& slot) {
  return protocol::write(protocol::ServerMessage{slot.name == kPartner ? mirrored(state) : state});
}

protocol::State GatewayService::state_now() const {
  protocol::State state = team_.state();
  if (!is_without_robot()) return state;
  const Time now = mission_clock_.now();
  state.person = people_.state_of(site_.agent, now);
  state.partner = people_.state_of(config_.partner, now);
  return state;
}

void GatewayService::acknowledge(const std::string& client, std::vector<protocol::Result> results) {
  const std::string text = protocol::write(
      protocol::ServerMessage{protocol::Ack{client, ledger_.settled_up_to(client), std::move(results)}});
  for (const auto& [socket, phone] : phones_) {
    if (phone.client == client) server_.send(socket, text);
  }
}

void GatewayService::send_to_all(const protocol::ServerMessage& message) {
  const std::string text = protocol::write(message);
  for (const auto& [socket, phone] : phones_) server_.send(socket, text);
}

void GatewayService::show_team() {
  const protocol::Session session = session_now();
  const bool session_changed = session != session_;
  session_ = session;
  for (const auto& [socket, phone] : phones_) {
    if (session_changed) server_.send_latest(socket, "session", session_text(phone.slot));
    if (team_.map().changed) server_.send_latest(socket, "map", team_.map().data);
    if (team_.plan().changed) server_.send_latest(socket, "plan", team_.plan().data);
    if (team_.sources().changed) server_.send_latest(socket, "sources", team_.sources().data);
    if (team_.belief().changed) server_.send_latest(socket, "belief", team_.belief().data, true);
  }
  for (const auto& event : team_.events()) send_to_all(event);
  if (phones_.empty()) return;
  if (const auto state = pacer_.next(state_now(), machine_clock_.now())) {
    for (const auto& [socket, phone] : phones_) server_.send_latest(socket, "state", state_text(*state, phone.slot));
  }
}

void GatewayService::renew_links() {
  const Time now = machine_clock_.now();
  for (auto& link : links_) {
    if ((link.file.empty() && !link.always) || desk_.has_token(link.slot, kRenewBefore)) continue;
    const bool unused = desk_.has_token(link.slot, Duration{0});
    if (link.issued && !unused && link.slot.exclusive) {
      // A phone has used it: no other is invited while that one is here or may come back.
      const bool here = std::any_of(phones_.begin(), phones_.end(),
                                    [&](const auto& one) { return one.second.slot.name == link.slot.name; });
      if (here || !link.alone_since) link.alone_since = now;
      if (now - *link.alone_since < kComeBack) continue;
    }
    link.issued = true;
    link.alone_since.reset();
    const std::string text = net::to_string(
        net::PairingLink{config_.link_host, server_.port(), desk_.issue(link.slot), certificate_.fingerprint});
    if (!link.file.empty()) write_private_file(link.file, text + "\n");
    if (link.slot.role == protocol::UserRole::Participant) participant_link_ = text;
  }
}

}  // namespace tandem::gateway
