#pragma once

#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.h>

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "services/bus/bus.hpp"

namespace tandem::bus {

/// Hears which participants are there, and which of them do not become peers for reasons of security.
///
/// Fast DDS tells that somebody was refused, but not why; what can be known is in the identity that each participant
/// announces. Thread-safe.
class HandshakeWatch {
 public:
  /// `secured`: is this side? `clock` must outlive it.
  HandshakeWatch(bool secured, const Clock& clock) : secured_(secured), clock_(clock) {}

  /// Those who are refused now, or refuse us; no more than a handful.
  [[nodiscard]] std::vector<RefusedPeer> refused() const;

  void discovered(const eprosima::fastrtps::rtps::ParticipantDiscoveryInfo& info);
  void authenticated(const eprosima::fastrtps::rtps::ParticipantAuthenticationInfo& info);

 private:
  struct Peer {
    std::string name;
    std::string authority;  ///< that signed its certificate, as it says; empty if it has none
    enum class Standing { Unknown, Admitted, Refused } standing = Standing::Unknown;
    Time since{};  ///< when it was heard of first
  };
  [[nodiscard]] std::string reason_to_refuse(const Peer& peer) const;

  [[nodiscard]] Peer* peer_of(const eprosima::fastrtps::rtps::GuidPrefix_t& prefix);

  const bool secured_;
  const Clock& clock_;
  mutable std::mutex mutex_;
  std::map<eprosima::fastrtps::rtps::GuidPrefix_t, Peer> peers_;
};

}  // namespace tandem::bus
