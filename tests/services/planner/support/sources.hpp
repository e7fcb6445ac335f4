#pragma once

#include <string>
#include <vector>

#include "services/planner/core/srs/reward_account.hpp"

namespace tandem {

/// A source without a limit, `per_s` within `radius_m`.
inline RewardSource disc_source(const std::string& id, const Eigen::Vector2d& centre, double radius_m, double per_s) {
  RewardSource source;
  source.id = id;
  source.boundary = Disc{centre, radius_m};
  source.inside = constant_ratio(per_s);
  return source;
}

/// The same with a pool.
inline RewardSource disc_source(const std::string& id, const Eigen::Vector2d& centre, double radius_m, double per_s,
                                double pool) {
  RewardSource source = disc_source(id, centre, radius_m, per_s);
  source.pool = pool;
  return source;
}

inline RewardWorld world_of(std::vector<std::string> agents, std::vector<RewardSource> sources,
                            std::vector<Relation> relations = {}) {
  RewardWorld world;
  world.agents = std::move(agents);
  world.sources = std::move(sources);
  world.relations = std::move(relations);
  return world;
}

inline Relation strict(const std::string& from, const std::string& to) {
  return {RelationKind::Strict, from, to, {}, 1.0, {}};
}

inline Relation soft(const std::string& from, const std::string& to, std::vector<std::string> agents = {}) {
  return {RelationKind::Soft, from, to, {}, 1.0, std::move(agents)};
}

inline Relation codependent(const std::string& one, const std::string& other, double coupling) {
  return {RelationKind::Codependent, one, other, {}, coupling, {}};
}

/// A world with an account of its own.
class Course {
 public:
  explicit Course(RewardWorld world) : world_(std::move(world)), account_(world_) { account_.record_to(&record_); }
  Course(const Course&) = delete;

  /// What each agent gets for moving so.
  std::vector<double> advance(const std::vector<AgentMove>& moves, double duration_s) {
    std::vector<double> rewards(moves.size(), 0.0);
    account_.advance(moves, duration_s, rewards);
    return rewards;
  }

  [[nodiscard]] std::size_t source(const std::string& id) const { return *index_of(world_.world(), id); }
  [[nodiscard]] RewardAccount& account() { return account_; }
  [[nodiscard]] const RewardRecord& record() const { return record_; }

 private:
  ResolvedWorld world_;
  RewardRecord record_;
  RewardAccount account_;
};

}  // namespace tandem
