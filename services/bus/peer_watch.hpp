#pragma once

#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "services/bus/core/endpoint_table.hpp"
#include "services/bus/core/rtps_guard.hpp"
#include "services/bus/handshake_watch.hpp"
#include "services/bus/mailbox.hpp"
#include "services/common/clock.hpp"

namespace tandem::bus {

/// Hears who comes and goes in a domain, and counts what came malformed or was dropped: to name the peers that do
/// wrong. Thread-safe.
class PeerWatch final : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  /// `secured`: must peers prove who they are? `clock` must outlive it.
  PeerWatch(std::string own_name, bool secured, const Clock& clock)
      : own_name_(std::move(own_name)), clock_(clock), handshakes_(secured, clock) {}

  /// A writer or reader of ours was made, or will be deleted.
  void own_found(Endpoint endpoint);
  void own_gone(const EndpointId& id);
  /// A sample of `writer` was dropped because of `problem`.
  void malformed(const std::string& topic, const WriterId& writer, std::string_view problem);
  /// A datagram that came `from` an address was dropped because of `fault`. How many were, of late.
  std::uint64_t dropped(const std::string& from, RtpsFault fault);

  /// X1 and X2 of late, and X3.
  [[nodiscard]] std::vector<PeerFault> faults(Concern concern) const;
  [[nodiscard]] std::vector<Endpoint> endpoints() const;
  [[nodiscard]] std::vector<std::string> participants() const;
  [[nodiscard]] std::vector<MalformedCount> malformed_counts() const;
  /// Those who are refused now for reasons of security, or refuse us; no more than a handful.
  [[nodiscard]] std::vector<RefusedPeer> refused() const { return handshakes_.refused(); }

 private:
  using Participant = eprosima::fastdds::dds::DomainParticipant;
  void on_participant_discovery(Participant*, eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& info) override;
  void onParticipantAuthentication(Participant*,
                                   eprosima::fastrtps::rtps::ParticipantAuthenticationInfo&& info) override;
  void on_publisher_discovery(Participant*, eprosima::fastrtps::rtps::WriterDiscoveryInfo&& info) override;
  void on_subscriber_discovery(Participant*, eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& info) override;

  /// The misfits among all endpoints, found anew only after somebody came or went: services ask often.
  [[nodiscard]] const std::vector<PeerFault>& known_misfits(Concern concern) const;

  std::string own_name_;
  const Clock& clock_;
  HandshakeWatch handshakes_;
  mutable std::mutex mutex_;
  EndpointTable table_;
  mutable std::map<Concern, std::vector<PeerFault>> misfits_;
  std::map<std::pair<std::string, WriterId>, MalformedCount> malformed_;
  struct Dropped {
    std::uint64_t count = 0;
    Time last{};
  };
  std::map<std::pair<std::string, RtpsFault>, Dropped> dropped_;  // by the address it came from
};

}  // namespace tandem::bus
