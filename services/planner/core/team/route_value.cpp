#include "services/planner/core/team/route_value.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace tandem {
namespace {

constexpr double kLikeWindow_s = 30.0;  ///< as in is_like()

/// Single precision inside blocks, double between them.
double weighted_sum(const std::vector<float>& weights, const std::vector<float>& values) {
  constexpr std::size_t kBlock = 256;
  double sum = 0.0;
  for (std::size_t begin = 0; begin < weights.size(); begin += kBlock) {
    const auto count = static_cast<Eigen::Index>(std::min(kBlock, weights.size() - begin));
    sum += Eigen::Map<const Eigen::VectorXf>(weights.data() + begin, count)
               .dot(Eigen::Map<const Eigen::VectorXf>(values.data() + begin, count));
  }
  return sum;
}

}  // namespace

RouteValue::RouteValue(const TeamGround& ground)
    : ground_(&ground),
      search_(&ground.problem->problem()),
      end_s_(static_cast<float>(search_->horizon_s + search_->tail_s)),
      total_(std::accumulate(ground.mass.begin(), ground.mass.end(), 0.0)),
      cursors_(ground.books.size()),
      objective_(search_->masses, search_->horizon_s, search_->tail_s) {
  double followed = 1.0;
  for (std::size_t m = 0; m < search_->members.size(); ++m) {
    for (const PathHypothesis& hypothesis : search_->members[m].hypotheses) {
      add_course(hypothesis.probability, static_cast<int>(m), &hypothesis);
      followed -= hypothesis.probability;
    }
  }
  add_course(followed, -1, nullptr);
}

void RouteValue::add_course(double weight, int astray, const PathHypothesis* hypothesis) {
  Course course;
  course.weight = weight;
  course.astray = astray;
  course.fixed_looks = ground_->problem->fixed_looks();
  if (hypothesis != nullptr) {
    const SearchMember& who = search_->members[static_cast<std::size_t>(astray)];
    hypothesis_seen_.push_back(
        sightings_along(hypothesis->path, who.pose.heading, search_->world->views(who.searcher)));
    course.fixed_looks.push_back(
        {&hypothesis_seen_.back(), 0.0, search_->world->searcher(who.searcher).detection_rate_per_s});
  }
  if (ground_->first_sight) {
    course.first_s.assign(ground_->mass.size(), end_s_);
    const auto see = [&](std::int32_t cell, double time_s) {
      float& first_s = course.first_s[static_cast<std::size_t>(cell)];
      if (time_s < search_->horizon_s) first_s = std::min(first_s, static_cast<float>(time_s));
    };
    for (const Look& look : course.fixed_looks) {
      for (std::size_t i = 0; i < look.seen->size(); ++i)
        see(look.seen->cells[i], look.start_s + look.seen->enter_s[i]);
    }
  }
  courses_.push_back(std::move(course));
}

double RouteValue::value_s(const Routes& routes) {
  if (search_->masses.size() > 1) return exact_s(routes);
  double value_s = 0.0;
  for (const Course& course : courses_) {
    value_s += course.weight * (ground_->first_sight ? first_sight_s(course, routes) : with_rates_s(course, routes));
  }
  return is_rejected(routes) ? value_s + kRejectedPenalty_s : value_s;
}

double RouteValue::exact_s(const Routes& routes) {
  double value_s = 0.0;
  for (const Course& course : courses_) {
    looks_ = course.fixed_looks;
    for (std::size_t m = 0; m < routes.size(); ++m) {
      if (static_cast<int>(m) != course.astray) ground_->problem->add_looks(m, routes[m], looks_);
    }
    value_s += course.weight * objective_.forecast(looks_).expected_time_s;
  }
  return is_rejected(routes) ? value_s + kRejectedPenalty_s : value_s;
}

double RouteValue::first_sight_s(const Course& course, const Routes& routes) {
  first_s_ = course.first_s;
  float* first_s = first_s_.data();
  for (std::size_t m = 0; m < routes.size(); ++m) {
    if (static_cast<int>(m) == course.astray) continue;
    const PreparedProblem::Member& who = ground_->problem->members()[m];
    LegBook& book = *ground_->books[m];
    double time_s = who.start_s;
    int place = who.start;
    for (const int next : routes[m]) {
      const CompactLeg& leg = book.leg(place, next);
      if (!leg.possible) continue;
      const auto start_s = static_cast<float>(time_s);
      const auto room_s = static_cast<float>(who.end_s - time_s);
      std::size_t count = leg.cells.size();
      while (count > 0 && leg.enter_s[count - 1] >= room_s) --count;
      const std::int32_t* cells = leg.cells.data();
      const float* enter_s = leg.enter_s.data();
      for (std::size_t i = 0; i < count; ++i) {  // stores always: whether it is sooner cannot be predicted
        const float seen_s = start_s + enter_s[i];
        float& first = first_s[cells[i]];
        first = seen_s < first ? seen_s : first;
      }
      time_s += leg.duration_s;
      place = next;
      if (time_s >= who.end_s) break;
    }
  }
  return weighted_sum(ground_->mass, first_s_) / total_;
}

/// A look of which `kept` of the mass is left, from `from_s` to `to_s`.
inline void RouteValue::look(std::int32_t cell, double from_s, float kept, float rate_inverse_s, double to_s) {
  float& left = left_[static_cast<std::size_t>(cell)];
  const double waiting_s = end_s_ - from_s;
  const double with_look_s = (1.0F - kept) * rate_inverse_s + kept * (end_s_ - to_s);
  saved_ += ground_->mass[static_cast<std::size_t>(cell)] * left * (waiting_s - with_look_s);
  left *= kept;
}

/// All looks of a leg that ends before the battery and the horizon.
void RouteValue::look_along(const CompactLeg& leg, float start_s, float rate_inverse_s) {
  const float* mass = ground_->mass.data();
  float* left = left_.data();
  const std::int32_t* cells = leg.cells.data();
  const float* enter_s = leg.enter_s.data();
  const float* stay_s = leg.stay_s.data();
  const float* kept = leg.kept.data();
  const float rest_s = end_s_ - start_s - rate_inverse_s;  // what finding at its beginning saves
  float saved = 0.0F;
  for (std::size_t i = 0, count = leg.cells.size(); i < count; ++i) {
    float& here = left[cells[i]];
    saved += mass[cells[i]] * here * ((1.0F - kept[i]) * (rest_s - enter_s[i]) + kept[i] * stay_s[i]);
    here *= kept[i];
  }
  saved_ += saved;
}

double RouteValue::with_rates_s(const Course& course, const Routes& routes) {
  left_.assign(ground_->mass.size(), 1.0F);
  saved_ = 0.0;
  const auto look_until = [&](std::int32_t cell, double from_s, double to_s, float kept, double rate_per_s,
                              double until_s) {
    if (from_s >= until_s) return;
    const auto rate_inverse_s = static_cast<float>(std::isinf(rate_per_s) ? 0.0 : 1.0 / rate_per_s);
    if (to_s > until_s) {
      to_s = until_s;
      if (!std::isinf(rate_per_s)) kept = static_cast<float>(std::exp(-rate_per_s * (to_s - from_s)));
    }
    look(cell, from_s, kept, rate_inverse_s, to_s);
  };
  for (const Look& fixed : course.fixed_looks) {
    for (std::size_t i = 0; i < fixed.seen->size(); ++i) {
      const double from_s = fixed.start_s + fixed.seen->enter_s[i];
      const double to_s = fixed.start_s + fixed.seen->leave_s[i];
      const double kept = std::isinf(fixed.rate_per_s) ? 0.0 : std::exp(-fixed.rate_per_s * (to_s - from_s));
      look_until(fixed.seen->cells[i], from_s, to_s, static_cast<float>(kept), fixed.rate_per_s, search_->horizon_s);
    }
  }
  for (std::size_t m = 0; m < routes.size(); ++m) {
    const PreparedProblem::Member& who = ground_->problem->members()[m];
    cursors_[m] = {0, who.start, who.start_s, static_cast<float>(who.heading_rad), &ground_->start_views[m]};
    if (static_cast<int>(m) == course.astray) cursors_[m].next = routes[m].size();
  }
  for (;;) {  // the leg that begins next
    std::size_t m = routes.size();
    for (std::size_t i = 0; i < routes.size(); ++i) {
      if (cursors_[i].next >= routes[i].size()) continue;
      if (cursors_[i].time_s >= ground_->problem->members()[i].end_s) continue;
      if (m == routes.size() || cursors_[i].time_s < cursors_[m].time_s) m = i;
    }
    if (m == routes.size()) break;
    Cursor& at = cursors_[m];
    const double until_s = ground_->problem->members()[m].end_s;
    LegBook& book = *ground_->books[m];
    const Searcher& searcher = book.actions().searcher();
    const int next = routes[m][at.next++];
    const CompactLeg& leg = book.leg(at.place, next);
    if (!leg.possible) continue;
    const double turn_s = turning_time_s(searcher, at.heading_rad, leg.initial_heading_rad);
    const double rate_per_s = searcher.detection_rate_per_s;
    if (turn_s > 0.0) {
      const auto kept = static_cast<float>(std::isinf(rate_per_s) ? 0.0 : std::exp(-rate_per_s * turn_s));
      for (const std::int32_t cell : *at.view) {
        look_until(cell, at.time_s, at.time_s + turn_s, kept, rate_per_s, until_s);
      }
      at.time_s += turn_s;
    }
    if (book.first_sight()) {
      for (std::size_t i = 0; i < leg.cells.size(); ++i) {
        const double seen_s = at.time_s + leg.enter_s[i];
        if (seen_s >= until_s) break;
        look(leg.cells[i], seen_s, 0.0F, 0.0F, seen_s);
      }
    } else if (at.time_s + leg.duration_s <= until_s) {
      look_along(leg, static_cast<float>(at.time_s), static_cast<float>(1.0 / rate_per_s));
    } else {
      for (std::size_t i = 0; i < leg.cells.size(); ++i) {
        const double from_s = at.time_s + leg.enter_s[i];
        if (from_s >= until_s) break;
        look_until(leg.cells[i], from_s, from_s + leg.stay_s[i], leg.kept[i], rate_per_s, until_s);
      }
    }
    at.time_s += leg.duration_s;
    at.heading_rad = leg.final_heading_rad;
    at.place = next;
    at.view = &leg.end_view;
  }
  return end_s_ - saved_ / total_;
}

bool RouteValue::is_rejected(const Routes& routes) const {
  if (search_->rejected.empty()) return false;
  std::vector<TimedPath> paths;
  for (std::size_t m = 0; m < routes.size(); ++m) {
    paths.push_back(ground_->problem->path(m, routes[m], kLikeWindow_s));
  }
  return std::ranges::any_of(search_->rejected, [&](const auto& rejected) { return is_like(paths, rejected); });
}

}  // namespace tandem
