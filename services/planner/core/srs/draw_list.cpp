#include "services/planner/core/srs/draw_list.hpp"

#include <algorithm>
#include <cmath>

#include "services/planner/core/srs/quadrature.hpp"
#include "services/planner/core/srs/segment_geometry.hpp"

namespace tandem {
namespace {

constexpr double kTolerance = 1e-12;  ///< of an integral, relative to its peak times its length

/// Whether a ratio of this peak could pay from the pool as it is now.
bool can_pay(const ResolvedPool& pool, double left, double peak) {
  if (peak == 0.0) return false;
  return left > 0.0 || (std::isfinite(pool.size) && !takes_from(pool, peak));
}

bool waits_for_entry(const ResolvedPool& pool, const ResolvedWorld& world, const RewardState& state) {
  return std::ranges::any_of(
      pool.gates, [&](std::size_t gate) { return world.gates()[gate].on_entry && state.through[gate] == 0; });
}

bool passes_by(const Disc& reach, const AgentMove& move) {
  const double margin_m = reach.radius_m + kOnBoundary_m;
  return (nearest_on_segment(move.from_in_map, move.to_in_map, reach.centre) - reach.centre).squaredNorm() >
         margin_m * margin_m;
}

const RewardRatio& ratio_of(const ResolvedSource& source, const DrawList::Contact& contact) {
  return contact.inside ? source.inside : source.outside;
}

}  // namespace

void DrawList::begin_move(const ResolvedWorld& world, const RewardState& state, const JointMove& joint) {
  contacts_.clear();
  shares_.assign({0.0, 1.0});
  outflow_per_s_.resize(world.pools().size(), 0.0);
  varies_.resize(world.pools().size(), 0);
  for (std::size_t pool = 0; pool < world.pools().size(); ++pool) {
    for (std::size_t agent = 0; agent < joint.moves.size(); ++agent) {
      if (!joint.moves[agent].present) continue;
      for (const std::size_t source : world.pools()[pool].sources) {
        add_contact(world, state, joint, pool, agent, source);
      }
    }
  }
  std::sort(shares_.begin(), shares_.end());
}

void DrawList::add_contact(const ResolvedWorld& world, const RewardState& state, const JointMove& joint,
                           std::size_t pool, std::size_t agent, std::size_t source) {
  const ResolvedSource& one = world.sources()[source];
  if ((one.targets & mask_of(agent)) == 0) return;
  const AgentMove& move = joint.moves[agent];
  if (one.reach && passes_by(*one.reach, move)) return;
  const bool inside_pays = can_pay(world.pools()[pool], state.left[pool], peak_of(one.inside));
  const bool outside_pays = can_pay(world.pools()[pool], state.left[pool], peak_of(one.outside));
  if (!inside_pays && !outside_pays && !waits_for_entry(world.pools()[pool], world, state)) return;
  if (!is_somewhere(one.boundary, joint) || is_silenced(one, agent, world, state)) return;
  append_level_crossings(one.boundary, 0.0, agent, joint, shares_);
  if (inside_pays && one.inside.shape == RatioShape::Ramp) {
    append_level_crossings(one.boundary, -one.inside.reach_m, agent, joint, shares_);
  }
  if (outside_pays && one.outside.shape == RatioShape::Ramp) {
    append_level_crossings(one.boundary, one.outside.reach_m, agent, joint, shares_);
  }
  contacts_.push_back({pool, agent, source, false, false});
}

void DrawList::begin_part(const ResolvedWorld& world, const JointMove& joint, double from_share, double to_share) {
  for (Contact& contact : contacts_) {
    const auto distance_at = [&](double part) {
      const double share = std::lerp(from_share, to_share, part);
      return vector_to(world.sources()[contact.source].boundary, contact.agent, joint, share).distance;
    };
    double distance = distance_at(0.5);
    // On the boundary in the middle: it goes along the boundary, or touches it in passing, which does not count.
    for (const double part : {0.2, 0.7}) {
      if (std::abs(distance) <= kOnBoundary_m) distance = distance_at(part);
    }
    contact.inside = distance <= kOnBoundary_m;
  }
}

void DrawList::begin_step(const ResolvedWorld& world, const RewardState& state) {
  for (const std::size_t pool : pools_) {
    outflow_per_s_[pool] = 0.0;
    varies_[pool] = 0;
  }
  pools_.clear();
  draws_.clear();
  for (std::size_t first = 0; first < contacts_.size();) {
    std::size_t last = first + 1;
    while (last < contacts_.size() && contacts_[last].pool == contacts_[first].pool &&
           contacts_[last].agent == contacts_[first].agent) {
      ++last;
    }
    add_draw(world, state, first, last);
    first = last;
  }
  std::sort(pools_.begin(), pools_.end());
  pools_.erase(std::unique(pools_.begin(), pools_.end()), pools_.end());
}

/// Of all contacts of an agent with a pool the strongest draws.
void DrawList::add_draw(const ResolvedWorld& world, const RewardState& state, std::size_t first, std::size_t last) {
  const std::size_t pool = contacts_[first].pool;
  const ResolvedPool& the_pool = world.pools()[pool];
  Draw draw{pool, contacts_[first].agent, contacts_[first].source, first, last, true, false, 0.0, 0.0};
  for (std::size_t i = first; i < last; ++i) {
    Contact& contact = contacts_[i];
    const ResolvedSource& source = world.sources()[contact.source];
    const RewardRatio& ratio = ratio_of(source, contact);
    contact.open = can_pay(the_pool, state.left[pool], peak_of(ratio)) && source.pace[draw.agent] > 0.0 &&
                   is_opened(source, state) && !is_silenced(source, draw.agent, world, state);
    if (!contact.open) continue;
    draw.constant = draw.constant && is_constant(ratio);
    const double per_s = peak_of(ratio) * source.pace[draw.agent];
    if (std::abs(per_s) > std::abs(draw.per_s)) {
      draw.per_s = per_s;
      draw.source = contact.source;
    }
  }
  if (draw.per_s == 0.0) return;
  draw.takes = !std::isfinite(the_pool.size) || takes_from(the_pool, draw.per_s);
  draws_.push_back(draw);
  if (!draw.takes) return;
  pools_.push_back(pool);
  for (const auto& coupling : the_pool.couplings) pools_.push_back(coupling.pool);
  if (draw.constant) {
    outflow_per_s_[pool] += std::abs(draw.per_s);
  } else {
    varies_[pool] = 1;
  }
}

double DrawList::per_s_at(const Draw& draw, const ResolvedWorld& world, const JointMove& joint, double time_s) const {
  if (draw.constant) return draw.per_s;
  double strongest = 0.0;
  for (std::size_t i = draw.first; i < draw.last; ++i) {
    if (!contacts_[i].open) continue;
    const ResolvedSource& source = world.sources()[contacts_[i].source];
    const auto vector = vector_to(source.boundary, draw.agent, joint, time_s / joint.duration_s);
    const double per_s = ratio_at(ratio_of(source, contacts_[i]), vector) * source.pace[draw.agent];
    if (std::abs(per_s) > std::abs(strongest)) strongest = per_s;
  }
  return strongest;
}

double DrawList::steady_amount(const Draw& draw, const ResolvedWorld& world, const JointMove& joint, double from_s,
                               double length_s) const {
  if (draw.constant) return draw.per_s * length_s;
  return integral([&](double later_s) { return per_s_at(draw, world, joint, from_s + later_s); }, 0.0, length_s,
                  kTolerance * std::abs(draw.per_s) * length_s);
}

double DrawList::own_loss(std::size_t pool, const ResolvedWorld& world, const JointMove& joint, double from_s,
                          double length_s) const {
  double sum = outflow_per_s_[pool] * length_s;
  if (varies_[pool] == 0) return sum;
  for (const Draw& draw : draws_) {
    if (draw.pool == pool && draw.takes && !draw.constant) {
      sum += std::abs(steady_amount(draw, world, joint, from_s, length_s));
    }
  }
  return sum;
}

double DrawList::loss(std::size_t pool, const ResolvedWorld& world, const JointMove& joint, double from_s,
                      double length_s) const {
  double sum = own_loss(pool, world, joint, from_s, length_s);
  for (const auto& coupling : world.pools()[pool].couplings) {
    sum += coupling.coupling * own_loss(coupling.pool, world, joint, from_s, length_s);
  }
  return sum;
}

double DrawList::time_until(double amount, std::size_t pool, const ResolvedWorld& world, const RewardState& state,
                            const JointMove& joint, double now_s, double end_s) const {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const ResolvedPool& the_pool = world.pools()[pool];
  if (the_pool.flow == Flow::Proportional) {
    if (amount >= state.left[pool] || outflow_per_s_[pool] <= 0.0) return kNever;
    return -std::log1p(-amount / state.left[pool]) / outflow_per_s_[pool];
  }
  double constant_per_s = outflow_per_s_[pool];
  bool varies = varies_[pool] != 0;
  for (const auto& coupling : the_pool.couplings) {
    constant_per_s += coupling.coupling * outflow_per_s_[coupling.pool];
    varies = varies || (varies_[coupling.pool] != 0 && coupling.coupling > 0.0);
  }
  if (!varies) return constant_per_s > 0.0 ? amount / constant_per_s : kNever;

  // The loss grows all the time: a false-position search between nothing and the end (Illinois rule).
  double low_s = 0.0;
  double high_s = end_s - now_s;
  double missing_low = -amount;
  double missing_high = loss(pool, world, joint, now_s, end_s - now_s) - amount;
  if (missing_high < 0.0) return kNever;
  int side = 0;
  for (int i = 0; i < 100 && high_s - low_s > 1e-14 * (end_s - now_s); ++i) {
    double at_s = (low_s * missing_high - high_s * missing_low) / (missing_high - missing_low);
    if (!(at_s > low_s && at_s < high_s)) at_s = 0.5 * (low_s + high_s);
    const double missing = loss(pool, world, joint, now_s, at_s) - amount;
    if (std::abs(missing) <= kTolerance * amount) return at_s;
    if (missing > 0.0) {
      high_s = at_s;
      missing_high = missing;
      if (side == 1) missing_low *= 0.5;
      side = 1;
    } else {
      low_s = at_s;
      missing_low = missing;
      if (side == -1) missing_high *= 0.5;
      side = -1;
    }
  }
  return high_s;
}

DrawList::Step DrawList::longest_step(const ResolvedWorld& world, const RewardState& state, const JointMove& joint,
                                      double now_s, double end_s) const {
  Step step{end_s - now_s, Step::kNone, 0.0};
  for (const std::size_t pool : pools_) {
    double amount = state.left[pool];
    for (const std::size_t gate : world.pools()[pool].gates) {
      if (state.through[gate] == 0) amount = std::min(amount, world.gates()[gate].amount - state.drawn[pool]);
    }
    if (!std::isfinite(amount) || amount <= 0.0) continue;
    const double until_s = time_until(amount, pool, world, state, joint, now_s, end_s);
    if (until_s <= step.length_s) step = {until_s, pool, amount};
  }
  return step;
}

}  // namespace tandem
