#include "services/planner/edit_messages.hpp"

namespace tandem {
namespace {

constexpr std::size_t kMostCorners = 1000;
constexpr double kTap_m = 1.0;  ///< the radius that a single point stands for

/// A drawn outline, or a tap.
std::optional<PlanarShape> region_of(const std::vector<msg::Point2>& outline) {
  Polygon polygon;
  if (outline.size() > kMostCorners) return std::nullopt;
  for (const msg::Point2& corner : outline) {
    const Eigen::Vector2d point_in_map{corner.x(), corner.y()};
    if (!point_in_map.allFinite()) return std::nullopt;
    if (polygon.corners.empty() || polygon.corners.back() != point_in_map) polygon.corners.push_back(point_in_map);
  }
  while (polygon.corners.size() > 1 && polygon.corners.back() == polygon.corners.front()) polygon.corners.pop_back();
  if (polygon.corners.size() == 1) return Disc{polygon.corners.front(), kTap_m};
  if (polygon.corners.size() < 3) return std::nullopt;
  return polygon;
}

}  // namespace

std::optional<BeliefEdit> to_core(const msg::BeliefEdit& message) {
  const auto region = region_of(message.boundary_in_map());
  if (!region) return std::nullopt;
  BeliefEdit edit;
  edit.region = *region;
  edit.strength = message.strength();
  edit.who = message.who();
  switch (message.kind()) {
    case msg::BELIEF_LIKELY_HERE:
      edit.kind = BeliefEdit::Kind::LikelyHere;
      return edit;
    case msg::BELIEF_NOT_HERE:
      edit.kind = BeliefEdit::Kind::NotHere;
      return edit;
    case msg::BELIEF_SEARCHED:
      edit.kind = BeliefEdit::Kind::Searched;
      return edit;
    case msg::BELIEF_LOOK_AGAIN:
      edit.kind = BeliefEdit::Kind::LookAgain;
      return edit;
  }
  return std::nullopt;  // a kind of a later version
}

std::optional<SourceEdit> to_core(const msg::SourceEdit& message) {
  SourceEdit edit;
  edit.source_id = message.source_id();
  edit.strength = message.strength();
  edit.targets = message.targets();
  edit.who = message.who();
  if (message.kind() == msg::EDIT_REMOVE) return edit;
  if (message.kind() == msg::EDIT_STAY_BEHIND) {
    edit.kind = SourceEdit::Kind::StayBehind;
    return edit;
  }
  const auto region = region_of(message.boundary_in_map());
  if (!region) return std::nullopt;
  edit.region = *region;
  switch (message.kind()) {
    case msg::EDIT_REMOVE:
    case msg::EDIT_STAY_BEHIND:
      break;
    case msg::EDIT_AVOID:
      edit.kind = SourceEdit::Kind::Avoid;
      return edit;
    case msg::EDIT_PASS_THROUGH:
      edit.kind = SourceEdit::Kind::PassThrough;
      return edit;
    case msg::EDIT_GO_TO:
      edit.kind = SourceEdit::Kind::GoTo;
      return edit;
  }
  return std::nullopt;  // a kind of a later version
}

}  // namespace tandem
