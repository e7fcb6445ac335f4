#include "services/bus/peer_watch.hpp"

#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.h>
#include <fastdds/rtps/reader/ReaderDiscoveryInfo.h>
#include <fastdds/rtps/writer/WriterDiscoveryInfo.h>

#include "services/bus/guid.hpp"

namespace tandem::bus {
namespace {

namespace rtps = eprosima::fastrtps::rtps;

/// So long after the last malformed sample or dropped datagram its sender is still named: longer than a look at a
/// screen.
constexpr Duration kNamedFor = std::chrono::seconds{10};
/// Senders that are remembered; an attacker can make as many as it likes.
constexpr std::size_t kMostSenders = 100;

template <class Data>
Endpoint endpoint_of(const Data& data, Endpoint::Kind kind) {
  Endpoint endpoint;
  endpoint.id = to_endpoint_id(data.guid());
  endpoint.kind = kind;
  endpoint.topic = data.topicName().to_string();
  endpoint.type = data.typeName().to_string();
  endpoint.keyed = data.topicKind() == rtps::WITH_KEY;
  endpoint.qos = to_endpoint_qos(data.m_qos.m_reliability, data.m_qos.m_durability, data.m_qos.m_ownership,
                                 data.m_qos.m_liveliness, data.m_qos.m_deadline);
  return endpoint;
}

}  // namespace

void PeerWatch::own_found(Endpoint endpoint) {
  const std::lock_guard lock{mutex_};
  endpoint.own = true;
  endpoint.participant = own_name_;
  misfits_.clear();
  table_.found(endpoint);
}

void PeerWatch::own_gone(const EndpointId& id) {
  const std::lock_guard lock{mutex_};
  misfits_.clear();
  table_.gone(id);
}

void PeerWatch::malformed(const std::string& topic, const WriterId& writer, std::string_view problem) {
  const std::lock_guard lock{mutex_};
  if (malformed_.size() >= kMostSenders) malformed_.clear();
  auto& entry = malformed_[{topic, writer}];
  entry.topic = topic;
  entry.writer = writer;
  entry.participant = table_.participant_of(writer);
  entry.problem = problem;
  ++entry.count;
  entry.last = clock_.now();
}

std::uint64_t PeerWatch::dropped(const std::string& from, RtpsFault fault) {
  const std::lock_guard lock{mutex_};
  if (dropped_.size() >= kMostSenders) dropped_.clear();
  auto& entry = dropped_[{from, fault}];
  if (clock_.now() - entry.last > kNamedFor) entry.count = 0;
  entry.last = clock_.now();
  return ++entry.count;
}

std::vector<PeerFault> PeerWatch::faults(Concern concern) const {
  const std::lock_guard lock{mutex_};
  std::vector<PeerFault> faults;
  for (const auto& [key, entry] : malformed_) {
    if (clock_.now() - entry.last > kNamedFor) continue;
    faults.push_back(
        {"X1", "malformed samples on " + entry.topic + " from " + entry.participant + " dropped: " + entry.problem});
  }
  for (const auto& [sender, entry] : dropped_) {
    if (clock_.now() - entry.last > kNamedFor) continue;
    faults.push_back({"X2", "datagrams from " + sender.first + " dropped: " + std::string{text_of(sender.second)}});
  }
  const auto& known = known_misfits(concern);
  faults.insert(faults.end(), known.begin(), known.end());
  return faults;
}

const std::vector<PeerFault>& PeerWatch::known_misfits(Concern concern) const {
  const auto known = misfits_.find(concern);
  if (known != misfits_.end()) return known->second;
  return misfits_[concern] = misfits(table_.endpoints(), concern);
}

std::vector<Endpoint> PeerWatch::endpoints() const {
  const std::lock_guard lock{mutex_};
  return table_.endpoints();
}

std::vector<std::string> PeerWatch::participants() const {
  const std::lock_guard lock{mutex_};
  return table_.participants();
}

std::vector<MalformedCount> PeerWatch::malformed_counts() const {
  const std::lock_guard lock{mutex_};
  std::vector<MalformedCount> counts;
  for (const auto& [key, entry] : malformed_) counts.push_back(entry);
  return counts;
}

void PeerWatch::on_participant_discovery(Participant*, rtps::ParticipantDiscoveryInfo&& info) {
  handshakes_.discovered(info);
  ParticipantId id{};
  for (std::size_t i = 0; i < id.size(); ++i) id[i] = info.info.m_guid.guidPrefix.value[i];
  const std::lock_guard lock{mutex_};
  misfits_.clear();
  const auto status = info.status;
  if (status == rtps::ParticipantDiscoveryInfo::REMOVED_PARTICIPANT ||
      status == rtps::ParticipantDiscoveryInfo::DROPPED_PARTICIPANT) {
    table_.participant_gone(id);
  } else {
    table_.participant_found(id, info.info.m_participantName.to_string());
  }
}

void PeerWatch::onParticipantAuthentication(Participant*, rtps::ParticipantAuthenticationInfo&& info) {
  handshakes_.authenticated(info);
}

void PeerWatch::on_publisher_discovery(Participant*, rtps::WriterDiscoveryInfo&& info) {
  const std::lock_guard lock{mutex_};
  misfits_.clear();
  if (info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER) {
    table_.gone(to_endpoint_id(info.info.guid()));
  } else {
    table_.found(endpoint_of(info.info, Endpoint::Kind::Writer));
  }
}

void PeerWatch::on_subscriber_discovery(Participant*, rtps::ReaderDiscoveryInfo&& info) {
  const std::lock_guard lock{mutex_};
  misfits_.clear();
  if (info.status == rtps::ReaderDiscoveryInfo::REMOVED_READER) {
    table_.gone(to_endpoint_id(info.info.guid()));
  } else {
    table_.found(endpoint_of(info.info, Endpoint::Kind::Reader));
  }
}

}  // namespace tandem::bus
