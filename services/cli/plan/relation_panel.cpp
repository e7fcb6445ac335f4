#include "services/cli/plan/relation_panel.hpp"

#include <algorithm>

namespace tandem::cli {
namespace {

using Eigen::Vector2d;

constexpr double kRowHeight = 84.0;
constexpr double kNodeHeight = 34.0;
constexpr double kGap = 24.0;
constexpr double kLineHeight = 16.0;
constexpr double kHead = 24.0;  ///< above the graph

struct Node {
  double width = 0.0;
  Vector2d centre = Vector2d::Zero();
};

std::string under_name(const RewardWorld& world, const RewardSource& source) {
  if (const SourceGroup* group = group_of(world, source.id)) {
    return group->id + ": " + (std::isfinite(group->pool) ? svg_number(group->pool) : "no limit");
  }
  if (std::isfinite(source.pool)) return "pool " + svg_number(source.pool);
  return svg_number(peak_of(source.inside)) + " per s";
}

/// Which row of the graph each source stands in: below all that come before it.
std::vector<std::size_t> ranks_of(const RewardWorld& world) {
  std::vector<std::size_t> ranks(world.sources.size(), 0);
  // Soft relations may go in a circle, so the rounds are counted.
  for (std::size_t round = 0; round < ranks.size(); ++round) {
    for (const Relation& relation : world.relations) {
      const auto from = index_of(world, relation.from);
      const auto to = index_of(world, relation.to);
      if (!from || !to) continue;
      if (relation.kind == RelationKind::Codependent) {
        ranks[*from] = ranks[*to] = std::max(ranks[*from], ranks[*to]);
      } else if (ranks[*to] < std::min(ranks[*from] + 1, ranks.size() - 1)) {
        ranks[*to] = ranks[*from] + 1;
      }
    }
  }
  return ranks;
}

/// Where each source stands in a panel of this width, its upper left corner at the origin; gives the height, too.
std::pair<std::vector<Node>, double> laid_out(const RewardWorld& world, double width) {
  std::vector<Node> nodes(world.sources.size());
  const auto ranks = ranks_of(world);
  const std::size_t last = ranks.empty() ? 0 : *std::ranges::max_element(ranks);
  double y = 0.5 * kNodeHeight + 4.0;
  const auto place_row = [&](const std::vector<std::size_t>& row, double used) {
    double x = 0.5 * (width - used + kGap);
    for (const std::size_t i : row) {
      nodes[i].centre = {x + 0.5 * nodes[i].width, y};
      x += nodes[i].width + kGap;
    }
    y += kRowHeight;
  };
  for (std::size_t rank = 0; rank <= last; ++rank) {
    std::vector<std::size_t> row;
    double used = 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (ranks[i] != rank) continue;
      nodes[i].width =
          std::max(width_of_text(world.sources[i].id, 12.0), width_of_text(under_name(world, world.sources[i]), 10.0)) +
          18.0;
      if (!row.empty() && used + nodes[i].width > width) {
        place_row(row, used);
        row.clear();
        used = 0.0;
      }
      row.push_back(i);
      used += nodes[i].width + kGap;
    }
    if (!row.empty()) place_row(row, used);
  }
  return {std::move(nodes), y - kRowHeight + 0.5 * kNodeHeight + 8.0};
}

/// Where the straight line from the centre of `node` to `target` leaves it.
Vector2d edge_of(const Node& node, const Vector2d& target) {
  const Vector2d way = target - node.centre;
  const double across = std::abs(way.x()) / (0.5 * node.width + 3.0);
  const double up = std::abs(way.y()) / (0.5 * kNodeHeight + 3.0);
  return node.centre + way / std::max({across, up, 1e-9});
}

std::string label_of(const Relation& relation) {
  std::string label;
  if (relation.kind == RelationKind::Codependent) {
    return relation.coupling == 1.0 ? label : svg_number(relation.coupling);
  }
  const Trigger& trigger = relation.trigger;
  if (trigger.kind == Trigger::Kind::Entry) label = "on entry";
  if (trigger.kind == Trigger::Kind::Amount) label = "after " + svg_number(trigger.value);
  if (trigger.kind == Trigger::Kind::Fraction && trigger.value < 1.0) label = svg_number(100.0 * trigger.value) + " %";
  for (const std::string& agent : relation.agents) label += (label.empty() ? "for " : ", ") + agent;
  return label;
}

void draw_relation(Svg& svg, const Relation& relation, const Node& from, const Node& to) {
  const bool same_row = from.centre.y() == to.centre.y();
  Vector2d begin = edge_of(from, to.centre);
  Vector2d end = edge_of(to, from.centre);
  Vector2d middle = 0.5 * (begin + end);
  std::string style = "fill=\"none\" stroke=\"#333\" stroke-width=\"1.6\"";
  if (relation.kind == RelationKind::Strict) style += " marker-end=\"url(#arrow)\"";
  if (relation.kind == RelationKind::Soft) style += " stroke-dasharray=\"5 4\" marker-end=\"url(#arrow)\"";
  if (relation.kind == RelationKind::Codependent) {
    style = "fill=\"none\" stroke=\"#333\" stroke-width=\"1.2\" marker-start=\"url(#dot)\" marker-end=\"url(#dot)\"";
  }
  const bool between =
      same_row && std::abs(from.centre.x() - to.centre.x()) > 0.5 * (from.width + to.width) + 1.5 * kGap;
  if (between) {  // others stand between the two: below them
    const double down = 0.5 * kNodeHeight;
    begin = from.centre + Vector2d{0.0, down + 3.0};
    end = to.centre + Vector2d{0.0, down + 3.0};
    middle = 0.5 * (begin + end) + Vector2d{0.0, 26.0};
  }
  const auto number = [](const Vector2d& p) { return svg_number(p.x()) + " " + svg_number(p.y()); };
  svg.path("M" + number(begin) + "Q" + number(middle) + " " + number(end), style);
  const std::string label = label_of(relation);
  if (!label.empty()) {
    svg.text(middle + Vector2d{4.0, 0.0}, label, std::string{"font-size=\"10\" fill=\"#333\" "} + kHalo);
  }
}

std::vector<std::string> lines_of(const PlanPicture& picture) {
  std::vector<std::string> lines;
  for (const Unawareness& unawareness : picture.world.unawareness) {
    for (const std::string& source : unawareness.sources) {
      const bool told = std::ranges::find(picture.informs, Inform{unawareness.agent, source}) != picture.informs.end();
      lines.push_back(unawareness.agent + " does not know of " + source +
                      (told ? ": is told first (costs " + svg_number(picture.world.message_cost) + ")" : ""));
    }
  }
  return lines;
}

}  // namespace

double height_of_relations(const PlanPicture& picture, double width) {
  return kHead + laid_out(picture.world, width).second + kLineHeight * static_cast<double>(lines_of(picture).size());
}

void draw_relations(Svg& svg, const PanelBox& box, const PlanPicture& picture) {
  const RewardWorld& world = picture.world;
  svg.text({box.x, box.y + 12.0}, "Sources and what they do to each other", "font-weight=\"bold\"");
  auto [nodes, height] = laid_out(world, box.width);
  for (Node& node : nodes) node.centre += Vector2d{box.x, box.y + kHead};
  for (const Relation& relation : world.relations) {
    const auto from = index_of(world, relation.from);
    const auto to = index_of(world, relation.to);
    if (from && to) draw_relation(svg, relation, nodes[*from], nodes[*to]);
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const RewardSource& source = world.sources[i];
    const Node& node = nodes[i];
    const double x = node.centre.x() - 0.5 * node.width;
    const double y = node.centre.y() - 0.5 * kNodeHeight;
    svg.rectangle(x, y, node.width, kNodeHeight, "rx=\"6\" fill=\"#fff\"");
    svg.rectangle(x, y, node.width, kNodeHeight,
                  "rx=\"6\" " + fill_of(source) + " stroke=\"" + colour_of(source.kind) + "\" stroke-width=\"1.5\"");
    svg.text(node.centre + Vector2d{0.0, -3.0}, source.id, std::string{"text-anchor=\"middle\" "} + kHalo);
    svg.text(node.centre + Vector2d{0.0, 11.0}, under_name(world, source),
             std::string{"text-anchor=\"middle\" font-size=\"10\" "} + kHalo);
  }
  double y = box.y + kHead + height;
  for (const std::string& line : lines_of(picture)) {
    y += kLineHeight;
    svg.text({box.x, y}, line, "font-size=\"11\"");
  }
}

}  // namespace tandem::cli
