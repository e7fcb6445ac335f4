#include "services/planner/core/search/belief_edit.hpp"

#include <vector>

namespace tandem {
namespace {

/// The cells whose points lie in the region; of one too small for that, the cell it is in.
std::vector<int> cells_in(const PlanarShape& region, const SearchArea& area) {
  std::vector<int> cells;
  for (int cell = 0; cell < area.size(); ++cell) {
    if (contains(region, area.point(cell))) cells.push_back(cell);
  }
  if (!cells.empty()) return cells;
  if (const auto cell = area.cell_at(inner_point(region))) cells.push_back(*cell);
  return cells;
}

std::optional<double> exposure_of(const std::string& word) {
  if (word == "roughly") return kSearchedRoughly;
  if (word.empty() || word == "well") return kSearchedWell;
  return std::nullopt;
}

}  // namespace

std::optional<std::string> edit_belief(SearchBelief& belief, const SearchArea& area, const BeliefEdit& edit,
                                       std::size_t agent) {
  const auto strength = strength_per_s(edit.strength.empty() ? "quite" : edit.strength);
  const auto exposure = exposure_of(edit.strength);
  const bool is_hint = edit.kind == BeliefEdit::Kind::LikelyHere || edit.kind == BeliefEdit::Kind::NotHere;
  if (is_hint ? !strength : edit.kind == BeliefEdit::Kind::Searched && !exposure) {
    return "nobody knows how much \"" + edit.strength + "\" is";
  }
  const std::vector<int> cells = cells_in(edit.region, area);
  double prior = 0.0;
  for (const int cell : cells) prior += belief.prior()[static_cast<std::size_t>(cell)];
  if (!(prior > 0.0)) return "nothing is searched there";
  switch (edit.kind) {
    case BeliefEdit::Kind::LikelyHere:
      belief.weigh(cells, hint_factor(*strength));
      break;
    case BeliefEdit::Kind::NotHere:
      belief.weigh(cells, 1.0 / hint_factor(*strength));
      break;
    case BeliefEdit::Kind::Searched:
      belief.claim_look(agent, cells, *exposure);
      break;
    case BeliefEdit::Kind::LookAgain:
      belief.look_again(cells);
      break;
  }
  return std::nullopt;
}

}  // namespace tandem
