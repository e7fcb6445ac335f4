#include "services/cli/plan/labels.hpp"

#include <algorithm>
#include <array>

#include "services/cli/plan/picture_style.hpp"

namespace tandem::cli {

using Eigen::Vector2d;

bool Labels::is_free(const Place& place) const {
  return std::ranges::none_of(taken_, [&](const Place& other) {
    return (place.low.array() < other.high.array()).all() && (other.low.array() < place.high.array()).all();
  });
}

void Labels::write(Svg& svg, const Place& place, const std::string& words, double font_size, const std::string& style) {
  taken_.push_back(place);
  svg.text({0.5 * (place.low.x() + place.high.x()), place.high.y() - 0.2 * font_size}, words,
           "text-anchor=\"middle\" font-size=\"" + svg_number(font_size) + "\" " + style + " " + kHalo);
}

void Labels::add(Svg& svg, const Vector2d& at, double off, const std::string& words, double font_size,
                 const std::string& style) {
  const Vector2d half{0.5 * width_of_text(words, font_size), 0.5 * font_size};
  const std::array<Vector2d, 4> centres{at - Vector2d{0.0, off + half.y()}, at + Vector2d{0.0, off + half.y()},
                                        at + Vector2d{off + half.x(), 0.0}, at - Vector2d{off + half.x(), 0.0}};
  const auto place_at = [&](const Vector2d& centre) { return Place{centre - half, centre + half}; };
  const auto free = std::ranges::find_if(centres, [&](const Vector2d& centre) { return is_free(place_at(centre)); });
  write(svg, place_at(free != centres.end() ? *free : centres.front()), words, font_size, style);
}

void Labels::add_if_free(Svg& svg, const Vector2d& at, const std::string& words, double font_size,
                         const std::string& style) {
  const Vector2d low = at + Vector2d{4.0, 2.0};
  const Place place{low, low + Vector2d{width_of_text(words, font_size), font_size}};
  if (is_free(place)) write(svg, place, words, font_size, style);
}

}  // namespace tandem::cli
