#pragma once

#include <vector>

#include "services/planner/core/search/observability.hpp"

namespace tandem {

/// Where the object may be, and who looked where: equations (22)-(27), corrected (digest G).
///
/// Holds the joint mass of each cell: the probability that the object lies there and was not detected yet. Looking at a
/// cell for t seconds at rate r leaves exp(-r t) of its mass, whoever looks and in whatever order. What a person says
/// of where the object may be reweights the prior; what they say of what was searched changes exposures. So the mass
/// always is weighted prior times exp(-exposure), and mass and what has been detected away add up to 1.
class SearchBelief {
 public:
  /// `prior` adds up to 1.
  explicit SearchBelief(std::vector<double> prior);

  /// Agent number `agent` has looked at `view` for `duration_s` [s] without finding anything.
  void look(std::size_t agent, const View& view, double detection_rate_per_s, double duration_s);
  /// From now on an object is `weight` (> 0) times as likely in each of `cells` as the prior says, before normalising.
  /// It takes the place of a weight given before.
  void weigh(const std::vector<int>& cells, double weight);
  /// Agent number `agent` has looked at `cells` with at least this `exposure`, unseen by anybody.
  void claim_look(std::size_t agent, const std::vector<int>& cells, double exposure);
  /// Nobody has looked at `cells` after all; weights below 1 do not count there any more either.
  void look_again(const std::vector<int>& cells);

  [[nodiscard]] const std::vector<double>& prior() const { return prior_; }
  [[nodiscard]] const std::vector<double>& mass() const { return mass_; }
  /// That the object was not detected yet.
  [[nodiscard]] double probability_left() const;
  /// P(object here | not detected), equation (26).
  [[nodiscard]] std::vector<double> posterior() const;
  /// The exposure of a cell: the sum of rate times time over all looks.
  [[nodiscard]] double exposure(int cell) const { return exposure_[static_cast<std::size_t>(cell)]; }
  /// Whether an object there would have been detected with at least `probability`.
  [[nodiscard]] bool is_explored(int cell, double probability) const;
  /// The agent that looked there first, -1 if none did.
  [[nodiscard]] int first_seen_by(int cell) const { return first_seen_by_[static_cast<std::size_t>(cell)]; }

 private:
  void renew_mass();

  std::vector<double> prior_;
  std::vector<double> weight_;
  std::vector<double> mass_;
  std::vector<double> exposure_;
  std::vector<int> first_seen_by_;
};

/// How much of the area is explored, and by whom it was seen first.
struct ExploredShares {
  double all = 0.0;              ///< [0, 1] of the floor
  std::vector<double> by_agent;  ///< they add up to `all`
};

/// Shares of the floor that is_explored() with `probability`.
[[nodiscard]] ExploredShares explored_shares(const SearchArea& area, const SearchBelief& belief, std::size_t agents,
                                             double probability);

}  // namespace tandem
