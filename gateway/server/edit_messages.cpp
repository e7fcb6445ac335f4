// What people draw, and what is recorded of their phones.
#include <algorithm>
#include <array>
#include <utility>

#include "gateway/server/gateway_messages.hpp"

namespace tandem::gateway {
namespace {

constexpr std::array<std::pair<const char*, msg::SourceEditKind>, 5> kSourceEdits{{
    {"avoid", msg::EDIT_AVOID},
    {"pass_through", msg::EDIT_PASS_THROUGH},
    {"go_to", msg::EDIT_GO_TO},
    {"stay_behind", msg::EDIT_STAY_BEHIND},
    {"remove", msg::EDIT_REMOVE},
}};
constexpr std::array<std::pair<const char*, msg::BeliefEditKind>, 4> kBeliefEdits{{
    {"likely_here", msg::BELIEF_LIKELY_HERE},
    {"not_here", msg::BELIEF_NOT_HERE},
    {"searched", msg::BELIEF_SEARCHED},
    {"look_again", msg::BELIEF_LOOK_AGAIN},
}};

template <class Kind, std::size_t kCount>
Kind kind_of(const std::array<std::pair<const char*, Kind>, kCount>& kinds, const std::string& word) {
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const auto& one) { return word == one.first; });
  return (found == kinds.end() ? kinds.front() : *found).second;
}

std::vector<msg::Point2> to_boundary(const std::vector<protocol::Point>& outline) {
  std::vector<msg::Point2> boundary;
  for (const auto& at : outline) {
    msg::Point2 point;
    point.x(at.x);
    point.y(at.y);
    boundary.push_back(point);
  }
  return boundary;
}

std::string spoken(const std::string& strength) {
  return strength == "a_bit" ? "a bit" : strength;
}

}  // namespace

std::optional<protocol::Source> to_phone(const msg::RewardSource& source) {
  const std::string edit = source.id().substr(0, source.id().find('-'));
  const bool drawn =
      std::any_of(kSourceEdits.begin(), kSourceEdits.end(), [&](const auto& one) { return edit == one.first; });
  if (!drawn || source.id().size() > 128) return std::nullopt;
  protocol::Source shown{
      .id = source.id(), .edit = edit, .outline = {}, .radius_m = source.radius_m(), .targets = source.targets()};
  for (const auto& corner : source.boundary_in_map()) shown.outline.push_back({corner.x(), corner.y()});
  return shown;
}

msg::SourceEdit to_source_edit(const protocol::Command& command, const Sender& sender) {
  const protocol::Drawing drawing = command.drawing.value_or(protocol::Drawing{});
  msg::SourceEdit edit;
  edit.robot(sender.robot);
  edit.id(sender.id);
  edit.stamp_ns(to_stamp_ns(sender.pressed));
  edit.who(sender.agent);
  edit.kind(kind_of(kSourceEdits, drawing.edit));
  edit.source_id(drawing.edit == "remove" ? drawing.source : drawing.edit + "-" + sender.id);
  edit.boundary_in_map(to_boundary(drawing.outline));
  edit.strength(spoken(drawing.strength));
  if (drawing.target == "me") edit.targets({sender.agent});
  if (drawing.target == "robot" || drawing.edit == "stay_behind") edit.targets({sender.robot});
  return edit;
}

msg::BeliefEdit to_belief_edit(const protocol::Command& command, const Sender& sender) {
  const protocol::Drawing drawing = command.drawing.value_or(protocol::Drawing{});
  msg::BeliefEdit edit;
  edit.robot(sender.robot);
  edit.id(sender.id);
  edit.stamp_ns(to_stamp_ns(sender.pressed));
  edit.who(sender.agent);
  edit.kind(kind_of(kBeliefEdits, drawing.edit));
  edit.boundary_in_map(to_boundary(drawing.outline));
  edit.strength(spoken(drawing.strength));
  return edit;
}

msg::ReminderEvent to_reminder(const protocol::Command& command, const Sender& sender) {
  const protocol::Reminder reminder = command.reminder.value_or(protocol::Reminder{});
  msg::ReminderEvent event;
  event.agent(sender.agent);
  event.id(sender.id);
  event.stamp_ns(to_stamp_ns(sender.pressed));
  event.kind(reminder.kind);
  event.fired(!reminder.obeyed_after_ms.has_value());
  event.obeyed(reminder.obeyed_after_ms.has_value());
  event.threshold_s(reminder.threshold_ms / 1000.0);
  return event;
}

msg::QuestionnaireAnswer to_layer_record(const protocol::Command& command, const Sender& sender) {
  const protocol::Layer layer = command.layer.value_or(protocol::Layer{});
  msg::QuestionnaireAnswer answer;
  answer.agent(sender.agent);
  answer.id(sender.id);
  answer.stamp_ns(to_stamp_ns(sender.pressed));
  answer.question("layer " + layer.name);
  answer.answer(layer.shown ? "shown" : "hidden");
  return answer;
}

}  // namespace tandem::gateway
