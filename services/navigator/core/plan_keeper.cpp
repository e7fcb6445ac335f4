#include "services/navigator/core/plan_keeper.hpp"

#include <utility>

namespace tandem::navigator {

bool PlanKeeper::is_alive(Time now) const {
  return plan_ && now - refreshed_ <= timeout_;
}

void PlanKeeper::receive(PlanNews news, Time received) {
  const bool planner_is_gone = received - planner_heard_ > timeout_;
  if (news.planner != planner_) {
    if (!planner_.empty() && !planner_is_gone) {  // one planner at a time: the first holds until it is gone
      note_rival(news, received);
      return;
    }
    planner_ = news.planner;
    planner_alive_ = false;
    last_sequence_number_ = 0;
  } else if (news.sequence_number != last_sequence_number_) {
    planner_alive_ = !planner_is_gone;
  }
  last_sequence_number_ = news.sequence_number;
  planner_heard_ = received;

  const bool same = plan_ && plan_->id == news.id;
  switch (news.state) {
    case PlanState::Accepted:
      plan_ = std::move(news);
      refreshed_ = received;
      break;
    case PlanState::Proposed:
      // The accepted plan goes on while its planner, which lives and has not withdrawn it, proposes the next one.
      if (!same && plan_ && plan_->state == PlanState::Accepted && is_alive(received)) {
        refreshed_ = received;
        break;
      }
      plan_ = std::move(news);
      refreshed_ = received;
      break;
    case PlanState::Rejected:
    case PlanState::Superseded:
      if (same) plan_.reset();
      break;
  }
}

void PlanKeeper::note_rival(const PlanNews& news, Time received) {
  if (news.planner != rival_.planner || received - rival_.last > timeout_) {
    rival_ = {news.planner, news.sequence_number, received, received, false};
    return;
  }
  rival_.repeats = rival_.repeats || news.sequence_number != rival_.sequence_number;
  rival_.last = received;
}

const std::string& PlanKeeper::rival(Time now) const {
  static const std::string kNobody;
  // Of one that was started again the first process is not heard after the second.
  const bool both_live = now - planner_heard_ <= timeout_ && now - rival_.last <= timeout_ && rival_.repeats &&
                         planner_heard_ > rival_.first;
  return both_live && rival_.planner != planner_ ? rival_.planner : kNobody;
}

PlanKeeper::Standing PlanKeeper::standing(Time now, const std::string& session) const {
  if (!plan_) return Standing::None;
  if (!is_alive(now)) return Standing::Dead;
  if (plan_->session != session) return Standing::OtherSession;
  if (now > plan_->valid_until) return Standing::Expired;
  if (plan_->state != PlanState::Accepted) return Standing::Proposed;
  if (!planner_alive_) return Standing::Unconfirmed;
  if (!rival(now).empty()) return Standing::TwoPlanners;
  if (plan_->points_in_map.empty()) return Standing::NoPath;
  return Standing::Executable;
}

}  // namespace tandem::navigator
