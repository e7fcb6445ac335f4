#include "services/mapping/map_messages.hpp"

#include <algorithm>
#include <cmath>

#include "services/mapping/core/map_file.hpp"

namespace tandem {
namespace {

constexpr std::uint32_t kMaxSide = 1'000'000;

bool is_sound(const msg::OccupancyGrid& message) {
  const msg::Pose& origin = message.map_from_grid();
  return message.width() <= kMaxSide && message.height() <= kMaxSide &&
         message.cells().size() == std::uint64_t{message.width()} * message.height() && message.resolution_m() > 0.0 &&
         std::isfinite(message.resolution_m()) && std::isfinite(origin.x()) && std::isfinite(origin.y()) &&
         std::isfinite(origin.heading());
}

}  // namespace

msg::OccupancyGrid to_message(const OccupancyGrid& grid, const std::string& map_id) {
  msg::OccupancyGrid message;
  message.map_id(map_id);
  message.sha256(sha256_of_cells(grid));
  message.resolution_m(grid.resolution_m());
  message.width(static_cast<std::uint32_t>(grid.width()));
  message.height(static_cast<std::uint32_t>(grid.height()));
  message.map_from_grid().x(grid.map_from_grid().x);
  message.map_from_grid().y(grid.map_from_grid().y);
  message.map_from_grid().heading(grid.map_from_grid().heading);
  message.cells().reserve(grid.cells().size());
  for (const CellState cell : grid.cells()) message.cells().push_back(static_cast<std::uint8_t>(cell));
  return message;
}

std::optional<OccupancyGrid> to_grid(const msg::OccupancyGrid& message) {
  if (!is_sound(message)) return std::nullopt;
  const msg::Pose& origin = message.map_from_grid();
  OccupancyGrid grid{static_cast<int>(message.width()),
                     static_cast<int>(message.height()),
                     message.resolution_m(),
                     {origin.x(), origin.y(), origin.heading()}};
  for (std::size_t i = 0; i < message.cells().size(); ++i) grid.cells()[i] = CellState{message.cells()[i]};
  if (sha256_of_cells(grid) != message.sha256()) return std::nullopt;
  const auto is_known = [](CellState cell) {
    return cell == CellState::Free || cell == CellState::Occupied || cell == CellState::Unknown;
  };
  if (!std::all_of(grid.cells().begin(), grid.cells().end(), is_known)) return std::nullopt;
  return grid;
}

}  // namespace tandem
