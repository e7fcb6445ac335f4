#pragma once

#include <functional>

#include "services/common/random.hpp"
#include "services/planner/core/team/search_problem.hpp"

namespace tandem {

/// A planner of a common search: takes up a problem, has a first plan at once, and makes it better for as long as it is
/// let.
///
/// Equal problem, options, seed and number of rollouts give the same plan, bit for bit, however the rollouts are cut
/// into run() calls. The value of the best plan never grows.
class Planner {
 public:
  Planner() = default;
  Planner(const Planner&) = delete;
  Planner& operator=(const Planner&) = delete;
  virtual ~Planner() = default;

  /// Takes up `problem`, which must outlive its planning, and makes the first plan.
  virtual void begin(const SearchProblem& problem, Rng rng) = 0;
  /// Makes `rollouts` more rollouts, or fewer if `stop` says so.
  virtual void run(int rollouts, const std::function<bool()>& stop) = 0;
  /// Rollouts made for this problem.
  [[nodiscard]] virtual int rollouts() const = 0;
  /// The best plan so far.
  [[nodiscard]] virtual JointPlan best() = 0;
  /// No plan for this problem has a smaller expected time; 0: not known. It takes time of its own, so ask for it when
  /// the plan is out.
  [[nodiscard]] virtual double lower_bound_s() { return 0.0; }
  /// Whether members are to tell each other what they have looked at. If not, each is to be planned for alone, from
  /// what it has seen itself.
  [[nodiscard]] virtual bool shares_looks() const { return true; }
  /// Whether a plan gets better by being made anew while everybody is still under way. If not, it is to be walked until
  /// the first path ends.
  [[nodiscard]] virtual bool replans_under_way() const { return true; }
};

}  // namespace tandem
