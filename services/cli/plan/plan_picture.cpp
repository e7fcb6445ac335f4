#include "services/cli/plan/plan_picture.hpp"

#include <algorithm>
#include <set>

#include "services/cli/plan/place_panel.hpp"
#include "services/cli/plan/relation_panel.hpp"
#include "services/cli/plan/time_panel.hpp"

namespace tandem::cli {
namespace {

constexpr double kWidth = 1060.0;
constexpr double kMargin = 20.0;
constexpr double kHead = 52.0;
constexpr double kMostHeight = 520.0;  ///< of the place
constexpr double kUnderPlace = 24.0;   ///< its scale
constexpr double kGap = 24.0;
constexpr double kLegend = 22.0;
constexpr double kLeastRelations = 380.0;  ///< the width of the graph

void define_signs(Svg& svg) {
  for (const SourceKind kind :
       {SourceKind::Environment, SourceKind::Action, SourceKind::Task, SourceKind::Interaction}) {
    const std::string colour = colour_of(kind);
    svg.define("<pattern id=\"hatch" + colour.substr(1) +
               "\" width=\"7\" height=\"7\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\">"
               "<rect width=\"7\" height=\"7\" fill=\"" +
               colour +
               "\" fill-opacity=\"0.08\"/>"
               "<rect width=\"2\" height=\"7\" fill=\"" +
               colour + "\" fill-opacity=\"0.6\"/></pattern>");
  }
  svg.define(
      "<marker id=\"arrow\" viewBox=\"0 0 10 10\" refX=\"9\" refY=\"5\" markerWidth=\"8\" markerHeight=\"8\" "
      "markerUnits=\"userSpaceOnUse\" orient=\"auto\"><path d=\"M0 0L10 5L0 10z\" fill=\"#333\"/></marker>");
  svg.define(
      "<marker id=\"dot\" viewBox=\"0 0 10 10\" refX=\"5\" refY=\"5\" markerWidth=\"7\" markerHeight=\"7\" "
      "markerUnits=\"userSpaceOnUse\"><circle cx=\"5\" cy=\"5\" r=\"4.5\" fill=\"#333\"/></marker>");
}

std::string name_of(SourceKind kind) {
  switch (kind) {
    case SourceKind::Environment:
      return "environment";
    case SourceKind::Action:
      return "action";
    case SourceKind::Interaction:
      return "interaction";
    case SourceKind::Task:
      break;
  }
  return "task";
}

/// What the signs mean, as far as they are used.
void draw_legend(Svg& svg, double x, double y, const PlanPicture& picture) {
  const auto words = [&](const std::string& text) {
    svg.text({x, y + 4.0}, text, "font-size=\"11\"");
    x += width_of_text(text, 11.0) + 18.0;
  };
  std::set<SourceKind> kinds;
  bool any_repels = false;
  bool any_moves = false;
  for (const RewardSource& source : picture.world.sources) {
    kinds.insert(source.kind);
    any_repels = any_repels || repels(source);
    any_moves = any_moves || !owners_of(source.boundary).empty();
  }
  const auto box = [&](const std::string& style) {
    svg.rectangle(x, y - 7.0, 16.0, 14.0, style);
    x += 21.0;
  };
  for (const SourceKind kind : kinds) {
    box("fill=\"" + colour_of(kind) + "\" fill-opacity=\"0.25\" stroke=\"" + colour_of(kind) + "\"");
    words(name_of(kind));
  }
  if (any_repels) {
    box("fill=\"url(#hatch009e73)\" stroke=\"#009e73\"");
    words("hatched: repels");
  }
  if (any_moves) {
    box("fill=\"none\" stroke=\"#333\" stroke-dasharray=\"6 3\"");
    words("moves: start; dotted: end");
  }
  const auto line = [&](const std::string& style) {
    svg.line({x, y}, {x + 26.0, y}, "stroke=\"#333\" stroke-width=\"1.5\" " + style);
    x += 33.0;
  };
  std::set<RelationKind> relations;
  for (const Relation& relation : picture.world.relations) relations.insert(relation.kind);
  if (relations.contains(RelationKind::Strict)) {
    line("marker-end=\"url(#arrow)\"");
    words("opens");
  }
  if (relations.contains(RelationKind::Soft)) {
    line("stroke-dasharray=\"5 4\" marker-end=\"url(#arrow)\"");
    words("pays only before");
  }
  if (relations.contains(RelationKind::Codependent)) {
    line("marker-start=\"url(#dot)\" marker-end=\"url(#dot)\"");
    words("drawn together");
  }
  if (!picture.belief.density.empty()) {
    for (const double shade : {0.1, 0.25, 0.4}) {
      svg.rectangle(x, y - 7.0, 14.0, 14.0, "fill=\"#0072b2\" fill-opacity=\"" + svg_number(shade) + "\"");
      x += 14.0;
    }
    x += 6.0;
    words("where the object may lie: the darker, the likelier");
  }
}

}  // namespace

std::string svg_of(const PlanPicture& picture) {
  const bool has_relations = !picture.world.sources.empty();
  const double place_width = kWidth - 2.0 * kMargin - (has_relations ? kLeastRelations + kGap : 0.0);
  const PanelBox place = fitted_place(picture, {kMargin, kHead, place_width, kMostHeight});
  PanelBox relations{place.x + place.width + kGap, kHead, 0.0, 0.0};
  if (has_relations) {
    relations.width = kWidth - kMargin - relations.x;
    relations.height = height_of_relations(picture, relations.width);
  }
  const double legend_y = kHead + std::max(place.height + kUnderPlace, relations.height) + 16.0;
  const PanelBox times{kMargin, legend_y + kLegend, kWidth - 2.0 * kMargin, height_of_times(picture)};
  const double height = times.y + times.height + 8.0;

  Svg svg{kWidth, height};
  define_signs(svg);
  svg.rectangle(0.0, 0.0, kWidth, height, "fill=\"#fafafa\"");
  svg.text({kMargin, 22.0}, picture.title, "font-size=\"16\" font-weight=\"bold\"");
  svg.text({kMargin, 40.0}, picture.subtitle, "fill=\"#333\"");
  draw_place(svg, place, picture);
  if (has_relations) draw_relations(svg, relations, picture);
  draw_legend(svg, kMargin, legend_y, picture);
  draw_times(svg, times, picture);
  return svg.file();
}

}  // namespace tandem::cli
