#include "services/bus/handshake_watch.hpp"

namespace tandem::bus {
namespace {

namespace rtps = eprosima::fastrtps::rtps;

static_assert(HAVE_SECURITY, "secure_link needs a Fast DDS that was built with SECURITY=ON, as Debian's is");

constexpr std::size_t kMostPeers = 64;   // whoever is on the Wi-Fi can announce thousands
constexpr std::size_t kMostRefused = 4;  // a handful is enough to read
constexpr std::size_t kLongestName = 60;
constexpr Duration kHandshake = std::chrono::seconds{5};  // takes a tenth of a second, and some more through loss

/// What a stranger says of itself, fit for a log.
std::string readable(const std::string& text) {
  std::string kept = text.substr(0, kLongestName);
  for (char& letter : kept) {
    if (letter < ' ' || letter > '~') letter = '?';
  }
  return kept;
}

/// Of the authority that signed the participant's certificate, as it says itself; empty without one.
std::string authority_of(const rtps::ParticipantProxyData& participant) {
  for (const auto& property : participant.identity_token_.properties()) {
    if (property.name() == "dds.ca.sn") return readable(property.value());
  }
  return participant.identity_token_.class_id().empty() ? "" : "unknown";
}

}  // namespace

std::vector<RefusedPeer> HandshakeWatch::refused() const {
  const std::lock_guard lock{mutex_};
  std::vector<RefusedPeer> all;
  for (const auto& [prefix, peer] : peers_) {
    if (all.size() == kMostRefused) break;
    std::string reason = reason_to_refuse(peer);
    if (!reason.empty()) all.push_back({peer.name, std::move(reason)});
  }
  return all;
}

std::string HandshakeWatch::reason_to_refuse(const Peer& peer) const {
  if (!secured_) return peer.authority.empty() ? "" : "its link is secured, and this host's is not";
  if (peer.standing == Peer::Standing::Admitted) return "";
  if (peer.standing == Peer::Standing::Unknown) {
    if (clock_.now() - peer.since < kHandshake) return "";
    return "no handshake: its certificate is of the authority \"" + peer.authority +
           "\"; is that another than ours, or are datagrams larger than a frame dropped on the way?";
  }
  if (peer.authority.empty()) return "it has no certificate: its link is not secured";
  return "its certificate of the authority \"" + peer.authority + "\" or its permissions do not hold here";
}

void HandshakeWatch::discovered(const rtps::ParticipantDiscoveryInfo& info) {
  using Info = rtps::ParticipantDiscoveryInfo;
  const std::lock_guard lock{mutex_};
  const auto& prefix = info.info.m_guid.guidPrefix;
  if (info.status == Info::REMOVED_PARTICIPANT || info.status == Info::DROPPED_PARTICIPANT) {
    peers_.erase(prefix);
    return;
  }
  Peer* peer = peer_of(prefix);
  if (peer == nullptr) return;
  peer->name = readable(info.info.m_participantName.to_string());
  peer->authority = authority_of(info.info);
}

void HandshakeWatch::authenticated(const rtps::ParticipantAuthenticationInfo& info) {
  const std::lock_guard lock{mutex_};
  Peer* peer = peer_of(info.guid.guidPrefix);
  if (peer == nullptr) return;
  peer->standing = info.status == rtps::ParticipantAuthenticationInfo::AUTHORIZED_PARTICIPANT ? Peer::Standing::Admitted
                                                                                              : Peer::Standing::Refused;
}

HandshakeWatch::Peer* HandshakeWatch::peer_of(const rtps::GuidPrefix_t& prefix) {
  if (const auto known = peers_.find(prefix); known != peers_.end()) return &known->second;
  if (peers_.size() >= kMostPeers) return nullptr;
  Peer& peer = peers_[prefix];
  peer.since = clock_.now();
  return &peer;
}

}  // namespace tandem::bus
