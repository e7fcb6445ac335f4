#include "services/planner/core/tasks/task_score.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {
namespace {

constexpr double kLeast = 1e-6;
constexpr double kShareOpened = 0.7;    ///< of what is opened that counts
constexpr double kShareBlocked = 0.3;   ///< of a source that waits for another
constexpr double kShareSilenced = 0.7;  ///< of what is lost
constexpr double kRest_s = 0.5;         ///< no action counts as shorter

}  // namespace

TaskScore::TaskScore(TaskModel& model) : model_(model) {
  const ResolvedWorld& world = model.world();
  const double horizon_s = static_cast<double>(model.horizon_ms()) * 1e-3;
  double most = 0.0;
  for (const ResolvedSource& source : world.sources()) {
    const double peak = std::abs(peak_of(source.inside)) * horizon_s;
    most = std::max(most, std::min(peak, std::abs(world.pools()[source.pool].size)));
  }
  if (most > 0.0) unit_ = most;
  opens_.resize(world.sources().size());
  silences_.resize(world.sources().size());
  for (std::size_t s = 0; s < world.sources().size(); ++s) {
    for (const std::size_t g : world.sources()[s].opened_by) {
      for (const std::size_t before : world.pools()[world.gates()[g].pool].sources) opens_[before].push_back(s);
    }
    for (const std::size_t g : world.sources()[s].silenced_by) {
      for (const std::size_t after : world.pools()[world.gates()[g].pool].sources) silences_[after].push_back(s);
    }
  }
}

/// What the agent could draw from the source if it had all the time.
double TaskScore::worth_of(const TaskState& state, std::size_t source, std::size_t agent) const {
  const double span_s = static_cast<double>(model_.limit_ms(agent) - state.now_ms) * 1e-3;
  const ResolvedSource& the_source = model_.world().sources()[source];
  const double most = std::max(0.0, peak_of(the_source.inside)) * the_source.pace[agent] * span_s;
  return std::min(model_.left(state, source), most) * the_source.worth[agent];
}

double TaskScore::operator()(const TaskState& state, const TaskAction& action, double impatience) {
  switch (action.kind) {
    case TaskActionKind::Tell:
      return action.source == 0 ? 1.0 : 0.5;
    case TaskActionKind::Goal:
      return 0.05;
    case TaskActionKind::Hold:
      return 0.02;
    case TaskActionKind::Wait:
      return kLeast;
    default:
      break;
  }
  const auto agent = static_cast<std::size_t>(action.agent);
  const auto s = static_cast<std::size_t>(action.source);
  const ResolvedSource& source = model_.world().sources()[s];
  if (action.kind == TaskActionKind::Accompany) {
    return std::max(kLeast, worth_of(state, s, agent) / unit_);
  }
  const double way_s = static_cast<double>(model_.arrival_ms(state, action) - state.now_ms) * 1e-3;
  const double draw = model_.draw_per_s(agent, s, action.place);
  const double rest_s = std::max(0.0, static_cast<double>(model_.limit_ms(agent) - state.now_ms) * 1e-3 - way_s);
  const double drawn = std::min(model_.left(state, s), draw * rest_s);
  double gain = drawn * source.worth[agent] * (is_opened(source, state.rewards) ? 1.0 : kShareBlocked);
  for (const std::size_t after : opens_[s]) {
    double most = 0.0;
    for (std::size_t a = 0; a < model_.agent_count(); ++a) {
      if (model_.is_hopeful(state, after, a)) most = std::max(most, worth_of(state, after, a));
    }
    gain += kShareOpened * most;
  }
  for (const std::size_t before : silences_[s]) {
    double most = 0.0;
    for (std::size_t a = 0; a < model_.agent_count(); ++a) {
      if (model_.is_hopeful(state, before, a)) most = std::max(most, worth_of(state, before, a));
    }
    gain -= kShareSilenced * most;
  }
  gain -= model_.cost_of_walking_per_s(agent) * way_s + model_.hazard_cost(state, action);
  gain /= unit_;
  const double time_s = kRest_s + way_s + (draw > 0.0 ? drawn / draw : 0.0);
  return gain > 0.0 ? kLeast + gain / std::pow(time_s, impatience) : kLeast / (1.0 - gain);
}

}  // namespace tandem
