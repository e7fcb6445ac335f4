#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "services/bus/core/peer_fault.hpp"
#include "services/common/time.hpp"

namespace tandem::bus {

/// Identifies a writer or a reader across processes (its DDS GUID).
using EndpointId = std::array<std::uint8_t, 16>;
/// Identifies a participant: the first bytes of the ids of its endpoints.
using ParticipantId = std::array<std::uint8_t, 12>;

/// The part of a QoS that a writer offers and a reader asks for; endpoints match only where the offer is enough. Kinds
/// are numbered as in DDS, weaker first.
struct EndpointQos {
  static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
  bool reliable = false;
  int durability = 0;  ///< volatile, transient local, transient, persistent
  bool exclusive = false;
  int liveliness = 0;  ///< automatic, by participant, by topic
  std::int64_t deadline_ns = kNever;
  std::int64_t liveliness_lease_ns = kNever;
};

/// A writer or a reader, ours or one that discovery told of.
struct Endpoint {
  enum class Kind { Writer, Reader };
  EndpointId id{};
  Kind kind = Kind::Writer;
  bool own = false;
  std::string topic;
  std::string type;
  bool keyed = false;
  EndpointQos qos;
  std::string participant;  ///< "planner@laptop1"
};

/// Malformed samples of one writer that were dropped.
struct MalformedCount {
  std::string topic;
  EndpointId writer{};
  std::string participant;  ///< whose it is
  std::string problem;      ///< of the last one
  std::uint64_t count = 0;
  Time last{};
};

/// All participants and endpoints of a domain.
class EndpointTable {
 public:
  void participant_found(const ParticipantId& id, const std::string& name) { names_[id] = name; }
  void participant_gone(const ParticipantId& id);
  /// A new endpoint, or one whose QoS changed.
  void found(const Endpoint& endpoint) { endpoints_[endpoint.id] = endpoint; }
  void gone(const EndpointId& id) { endpoints_.erase(id); }

  /// By topic, writers first, then by participant.
  [[nodiscard]] std::vector<Endpoint> endpoints() const;
  /// The name of the participant that the endpoint is of; "somebody" if it is not known.
  [[nodiscard]] std::string participant_of(const EndpointId& id) const;
  /// The names of all participants, sorted; a name stands as often as it is used.
  [[nodiscard]] std::vector<std::string> participants() const;

 private:
  std::map<ParticipantId, std::string> names_;
  std::map<EndpointId, Endpoint> endpoints_;
};

/// Which pairs of endpoints are looked at.
enum class Concern {
  Own,  ///< at least one is ours: a service says what it cannot hear, or who cannot hear it
  All,  ///< any two: for somebody who watches
};

/// X3: endpoints of one topic that cannot talk to each other, because of another type or a QoS that does not fit. Types
/// are compared with our own endpoints' alone. Each is named once, sorted.
[[nodiscard]] std::vector<PeerFault> misfits(const std::vector<Endpoint>& endpoints, Concern concern);

}  // namespace tandem::bus
