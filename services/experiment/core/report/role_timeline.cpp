#include "services/experiment/core/report/role_timeline.hpp"

#include <algorithm>

namespace tandem::experiment {
namespace {

std::size_t index_of(Role role) {
  return static_cast<std::size_t>(std::ranges::find(kRoles, role) - kRoles.begin());
}

}  // namespace

std::vector<RoleSpan> role_spans(const EpisodeLog& episode) {
  std::vector<RoleSpan> spans;
  for (const PlanAt& plan : episode.plans) {
    if (plan.state != PlanAt::State::Proposed && plan.state != PlanAt::State::Accepted) continue;
    const double from_s = std::max(0.0, plan.time_s);
    if (from_s >= episode.duration_s) break;
    if (!spans.empty()) {
      if (spans.back().role == plan.role) continue;
      spans.back().to_s = from_s;
    }
    spans.push_back({from_s, episode.duration_s, plan.role});
  }
  return spans;
}

std::array<double, kRoles.size()> role_shares(const EpisodeLog& episode) {
  std::array<double, kRoles.size()> shares{};
  double whole_s = 0.0;
  for (const RoleSpan& span : role_spans(episode)) {
    shares[index_of(span.role)] += span.to_s - span.from_s;
    whole_s += span.to_s - span.from_s;
  }
  if (whole_s > 0.0) {
    for (double& share : shares) share /= whole_s;
  }
  return shares;
}

std::vector<RolesAt> roles_over_time(std::span<const EpisodeLog* const> episodes, double step_s) {
  double last_s = 0.0;
  std::vector<std::vector<RoleSpan>> spans;
  for (const EpisodeLog* episode : episodes) {
    last_s = std::max(last_s, episode->duration_s);
    spans.push_back(role_spans(*episode));
  }
  std::vector<RolesAt> moments;
  for (int i = 0; i * step_s < last_s; ++i) {
    RolesAt moment{.time_s = i * step_s};
    for (std::size_t k = 0; k < episodes.size(); ++k) {
      if (moment.time_s >= episodes[k]->duration_s) continue;
      ++moment.ongoing;
      const auto span = std::ranges::find_if(
          spans[k], [&](const RoleSpan& one) { return one.from_s <= moment.time_s && moment.time_s < one.to_s; });
      if (span != spans[k].end()) ++moment.in[index_of(span->role)];
    }
    moments.push_back(moment);
  }
  return moments;
}

}  // namespace tandem::experiment
