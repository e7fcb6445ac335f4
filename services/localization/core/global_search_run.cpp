#include <algorithm>
#include <cmath>
#include <numbers>

#include "services/common/angle.hpp"
#include "services/localization/core/global_search.hpp"

namespace tandem {
namespace {

constexpr int kTop = GlobalSearch::kLevels - 1;

}  // namespace

GlobalSearchRun::GlobalSearchRun(const GlobalSearch& search, std::span<const Eigen::Vector2d> endpoints_in_base,
                                 const GlobalSearchOptions& options)
    : options_(options), limits_(options.within, search.grid_from_map(), search.step_m()) {
  std::vector<Eigen::Vector2d> near;
  for (const Eigen::Vector2d& endpoint : endpoints_in_base) {
    if (endpoint.norm() < GlobalSearch::kReachM) near.push_back(endpoint);
  }
  done_ = near.empty();
  const auto headings = std::max(1.0, std::ceil(2.0 * std::numbers::pi / options.step_rad));
  shifts_.resize(static_cast<std::size_t>(headings));
  for (std::size_t i = 0; i < shifts_.size(); ++i) {
    if (!limits_.has_heading(heading_of(static_cast<int>(i)))) continue;
    const Pose2 turn{0.0, 0.0, 2.0 * std::numbers::pi * static_cast<double>(i) / headings};
    for (const Eigen::Vector2d& endpoint : near) shifts_[i].push_back(search.shift_of(turn * endpoint));
  }
  full_ = 255.0 * static_cast<double>(near.size());
  next_.level = kTop;
  begin_heading(0);
}

void GlobalSearchRun::advance(const GlobalSearch& search, std::size_t boxes) {
  const std::size_t until = scored_ + boxes;
  while (!done_ && scored_ < until) {
    if (all_begun_) {
      open_best(search);
    } else {
      score_next_of_largest(search);
    }
  }
}

double GlobalSearchRun::heading_of(int heading) const {
  return wrap_to_pi(2.0 * std::numbers::pi * heading / static_cast<double>(shifts_.size()));
}

double GlobalSearchRun::least_sum() const {
  const double least = found_.empty() ? 0.0 : found_.front().score - options_.margin;
  return std::max(least, options_.floor) * full_;
}

void GlobalSearchRun::score(const GlobalSearch& search, Box box) {
  ++scored_;
  if (box.column >= search.width() || box.row >= search.height()) return;
  if (!limits_.meets(box.column, box.row, 1 << box.level)) return;
  if (!search.is_free(box.level, box.column, box.row)) return;
  const auto sum = search.best_sum(box.level, box.column, box.row, shifts_[static_cast<std::size_t>(box.heading)],
                                   static_cast<int>(std::ceil(least_sum())));
  if (!sum) return;
  box.score = *sum;
  boxes_.push(box);
}

void GlobalSearchRun::score_next_of_largest(const GlobalSearch& search) {
  score(search, next_);
  next_.column += 1 << kTop;
  if (next_.column < search.width()) return;
  next_.column = 0;
  next_.row += 1 << kTop;
  if (next_.row < search.height()) return;
  next_.row = 0;
  begin_heading(next_.heading + 1);
}

/// The first heading from this one on that is asked for, if there is any.
void GlobalSearchRun::begin_heading(int heading) {
  while (heading < static_cast<int>(shifts_.size()) && !limits_.has_heading(heading_of(heading))) ++heading;
  next_.heading = heading;
  all_begun_ = heading == static_cast<int>(shifts_.size());
}

bool GlobalSearchRun::is_known(const GlobalSearch& search, const Box& box) const {
  const double half_m = 0.5 * search.step_m() * (1 << box.level);
  const Eigen::Vector2d middle{box.column * search.step_m() + half_m, box.row * search.step_m() + half_m};
  return std::any_of(found_.begin(), found_.end(), [&](const Candidate& candidate) {
    return (candidate.map_from_base.position() - middle).norm() + half_m < options_.apart_m &&
           std::abs(turn_between(candidate.map_from_base.heading, heading_of(box.heading))) < options_.apart_rad;
  });
}

void GlobalSearchRun::open_best(const GlobalSearch& search) {
  if (boxes_.empty() || opened_ == options_.max_nodes || boxes_.top().score < least_sum()) return finish(search);
  const Box box = boxes_.top();
  boxes_.pop();
  ++opened_;
  ++scored_;
  if (is_known(search, box)) return;
  if (box.level == 0) {  // no box left can be better
    const double step_m = search.step_m();
    found_.push_back(
        {{(box.column + 0.5) * step_m, (box.row + 0.5) * step_m, heading_of(box.heading)}, box.score / full_});
    if (found_.size() == options_.count) finish(search);
    return;
  }
  const int half = 1 << (box.level - 1);
  for (const int row : {box.row, box.row + half}) {
    for (const int column : {box.column, box.column + half}) {
      score(search, {.heading = box.heading, .level = box.level - 1, .column = column, .row = row});
    }
  }
}

void GlobalSearchRun::finish(const GlobalSearch& search) {
  for (Candidate& candidate : found_) candidate.map_from_base = search.in_map(candidate.map_from_base);
  boxes_ = {};
  done_ = true;
}

}  // namespace tandem
