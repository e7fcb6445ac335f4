#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "services/planner/core/team/planner.hpp"

namespace tandem {

/// The other program does not answer, or not with a plan that the members can walk; what() says which of them.
class RemotePlannerError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct RemotePlannerOptions {
  std::string command;       ///< A shell command that speaks docs/planner_protocol.md on standard input and output.
  double budget_s = 0.2;     ///< What it is told it may take for a plan [s].
  double patience_s = 30.0;  ///< After so long without an answer it is given up [s].
};

/// A planner that is another program, in whatever language: it gets the problem as a line of JSON and answers with a
/// joint plan as a line of JSON. Its plan is checked and gets its value here, like every planner's.
class RemotePlanner final : public Planner {
 public:
  /// Starts the program.
  explicit RemotePlanner(const RemotePlannerOptions& options);
  /// Ends it.
  ~RemotePlanner() override;

  /// Throws RemotePlannerError.
  void begin(const SearchProblem& problem, Rng rng) override;
  /// It took its time in begin().
  void run(int rollouts, const std::function<bool()>& stop) override;
  [[nodiscard]] int rollouts() const override { return 0; }
  [[nodiscard]] JointPlan best() override { return best_; }

 private:
  class Program;

  RemotePlannerOptions options_;
  std::unique_ptr<Program> program_;
  const SearchWorld* told_world_ = nullptr;  ///< whose map it knows
  JointPlan best_;
};

}  // namespace tandem
