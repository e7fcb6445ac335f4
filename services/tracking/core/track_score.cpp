#include "services/tracking/core/track_score.hpp"

#include <algorithm>
#include <limits>

#include "services/tracking/core/assignment.hpp"

namespace tandem::tracking {

void TrackScore::add(const std::vector<AnnotatedPerson>& annotated, const std::vector<FoundPerson>& found) {
  ++moments_;
  annotations_ += annotated.size();
  Eigen::MatrixXd costs(static_cast<Eigen::Index>(annotated.size()), static_cast<Eigen::Index>(found.size()));
  for (std::size_t a = 0; a < annotated.size(); ++a) {
    const auto had = track_of_.find(annotated[a].id);
    for (std::size_t f = 0; f < found.size(); ++f) {
      const double distance = (annotated[a].position - found[f].position).norm();
      const bool kept = had != track_of_.end() && had->second == found[f].id;
      // Whoever was kept goes before any other choice.
      const double cost = kept ? distance - 1e3 : distance;
      costs(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(f)) =
          distance <= gate_m_ ? cost : std::numeric_limits<double>::infinity();
    }
  }
  const auto given = best_assignment(costs);
  std::size_t used = 0;
  for (std::size_t a = 0; a < annotated.size(); ++a) {
    if (!given[a]) continue;
    ++used;
    const FoundPerson& track = found[static_cast<std::size_t>(*given[a])];
    distances_m_.push_back((annotated[a].position - track.position).norm());
    const auto [had, is_first] = track_of_.try_emplace(annotated[a].id, track.id);
    if (!is_first && had->second != track.id) ++id_switches_;
    had->second = track.id;
  }
  false_tracks_ += found.size() - used;
}

std::optional<double> TrackScore::recall() const {
  if (annotations_ == 0) return std::nullopt;
  return static_cast<double>(distances_m_.size()) / static_cast<double>(annotations_);
}

std::optional<double> TrackScore::median_m() const {
  return median_of(distances_m_);
}

double TrackScore::false_per_moment() const {
  return moments_ == 0 ? 0.0 : static_cast<double>(false_tracks_) / static_cast<double>(moments_);
}

std::optional<double> median_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace tandem::tracking
