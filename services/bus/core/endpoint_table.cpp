#include "services/bus/core/endpoint_table.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include "services/common/format.hpp"

namespace tandem::bus {
namespace {

ParticipantId participant_id_of(const EndpointId& id) {
  ParticipantId participant{};
  std::copy_n(id.begin(), participant.size(), participant.begin());
  return participant;
}

/// What of the writer's offer is not enough: "offers best effort, ... asks for reliable"; empty if all is.
struct Gap {
  std::string offered;
  std::string asked;
};

std::string seconds_text(std::int64_t ns) {
  return ns == EndpointQos::kNever ? "none" : formatted("%.3f s", static_cast<double>(ns) * 1e-9);
}

Gap gap_between(const EndpointQos& offered, const EndpointQos& asked) {
  static constexpr const char* kDurability[] = {"volatile", "transient local", "transient", "persistent"};
  static constexpr const char* kLiveliness[] = {"automatic", "manual by participant", "manual by topic"};
  if (asked.reliable && !offered.reliable) return {"best effort", "reliable"};
  if (offered.durability < asked.durability) {
    return {std::string{kDurability[offered.durability & 3]} + " data", std::string{kDurability[asked.durability & 3]}};
  }
  if (offered.exclusive != asked.exclusive) {
    return {offered.exclusive ? "exclusive ownership" : "shared ownership", asked.exclusive ? "exclusive" : "shared"};
  }
  if (offered.deadline_ns > asked.deadline_ns) {
    return {"deadline " + seconds_text(offered.deadline_ns), seconds_text(asked.deadline_ns)};
  }
  if (offered.liveliness < asked.liveliness) {
    return {std::string{kLiveliness[std::clamp(offered.liveliness, 0, 2)]} + " liveliness",
            kLiveliness[std::clamp(asked.liveliness, 0, 2)]};
  }
  if (offered.liveliness_lease_ns > asked.liveliness_lease_ns) {
    return {"liveliness lease " + seconds_text(offered.liveliness_lease_ns), seconds_text(asked.liveliness_lease_ns)};
  }
  return {};
}

std::string type_text(const Endpoint& endpoint, const Endpoint& other) {
  if (endpoint.type != other.type) return endpoint.type;
  return endpoint.type + (endpoint.keyed ? " with a key" : " without a key");
}

/// What keeps `peer` and our own `own` from being of one topic; empty if nothing does.
std::string wrong_type(const Endpoint& own, const Endpoint& peer) {
  if (own.type == peer.type && own.keyed == peer.keyed) return "";
  return formatted("wrong type on %s: %s %s %s, ours is %s", own.topic.c_str(), peer.participant.c_str(),
                   peer.kind == Endpoint::Kind::Writer ? "writes" : "reads", type_text(peer, own).c_str(),
                   type_text(own, peer).c_str());
}

std::string wrong_qos(const Endpoint& one, const Endpoint& other) {
  if (one.kind == other.kind || one.type != other.type) return "";
  const Endpoint& writer = one.kind == Endpoint::Kind::Writer ? one : other;
  const Endpoint& reader = one.kind == Endpoint::Kind::Writer ? other : one;
  const Gap gap = gap_between(writer.qos, reader.qos);
  if (gap.offered.empty()) return "";
  return formatted("incompatible QoS on %s: %s offers %s, %s asks for %s", one.topic.c_str(),
                   writer.participant.c_str(), gap.offered.c_str(), reader.participant.c_str(), gap.asked.c_str());
}

std::string misfit(const Endpoint& one, const Endpoint& other, Concern concern) {
  if (one.topic != other.topic || (one.own && other.own)) return "";
  if (one.own || other.own) {
    std::string problem = one.own ? wrong_type(one, other) : wrong_type(other, one);
    if (!problem.empty()) return problem;
  } else if (concern == Concern::Own) {
    return "";
  }
  return wrong_qos(one, other);
}

}  // namespace

void EndpointTable::participant_gone(const ParticipantId& id) {
  names_.erase(id);
  std::erase_if(endpoints_, [&](const auto& item) { return participant_id_of(item.first) == id; });
}

std::vector<Endpoint> EndpointTable::endpoints() const {
  std::vector<Endpoint> all;
  for (const auto& [id, endpoint] : endpoints_) {
    all.push_back(endpoint);
    if (!endpoint.own) all.back().participant = participant_of(id);
  }
  std::sort(all.begin(), all.end(), [](const Endpoint& a, const Endpoint& b) {
    return std::tie(a.topic, a.kind, a.participant, a.id) < std::tie(b.topic, b.kind, b.participant, b.id);
  });
  return all;
}

std::string EndpointTable::participant_of(const EndpointId& id) const {
  const auto known = names_.find(participant_id_of(id));
  return known == names_.end() || known->second.empty() ? "somebody" : known->second;
}

std::vector<std::string> EndpointTable::participants() const {
  std::vector<std::string> names;
  for (const auto& [id, name] : names_) names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<PeerFault> misfits(const std::vector<Endpoint>& endpoints, Concern concern) {
  std::set<PeerFault> faults;
  for (auto one = endpoints.begin(); one != endpoints.end(); ++one) {
    for (auto other = one + 1; other != endpoints.end() && other->topic == one->topic; ++other) {
      std::string what = misfit(*one, *other, concern);
      if (!what.empty()) faults.insert({"X3", std::move(what)});
    }
  }
  return {faults.begin(), faults.end()};
}

}  // namespace tandem::bus
