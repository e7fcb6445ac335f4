#pragma once

#include <cmath>
#include <vector>

namespace tandem {
namespace detail {

template <typename Function>
void append_safe_roots_between(const Function& function, double change, double width, double zero, double a,
                               double at_a, double b, double at_b, std::vector<double>& roots) {
  const bool crosses = (at_a > 0.0) != (at_b > 0.0);
  // To zero and back it would have to change by more than it can.
  if (!crosses && std::abs(at_a) + std::abs(at_b) > change * (b - a)) return;
  double middle = 0.5 * (a + b);
  double at_middle = function(middle);
  if (std::abs(at_a) <= zero && std::abs(at_b) <= zero && std::abs(at_middle) <= zero) return;  // stays on it
  if (b - a > width) {
    append_safe_roots_between(function, change, width, zero, a, at_a, middle, at_middle, roots);
    append_safe_roots_between(function, change, width, zero, middle, at_middle, b, at_b, roots);
    return;
  }
  if (!crosses) return;
  for (int i = 0; i < 60 && b - a > 1e-13; ++i) {
    const bool in_first_half = (at_a > 0.0) != (at_middle > 0.0);
    (in_first_half ? b : a) = middle;
    (in_first_half ? at_b : at_a) = at_middle;
    middle = 0.5 * (a + b);
    at_middle = function(middle);
  }
  roots.push_back(middle);
}

}  // namespace detail

/// Appends where `function` changes its sign in [0, 1], to 1e-12; ascending.
///
/// `change` bounds how much it can change over the whole interval (its Lipschitz constant): a part that cannot reach
/// zero is not looked into. Two changes of sign less than `width` apart may be missed. Where it stays within `zero`
/// of zero it has no changes of sign.
template <typename Function>
void append_safe_roots(const Function& function, double change, double width, double zero, std::vector<double>& roots) {
  detail::append_safe_roots_between(function, change, width, zero, 0.0, function(0.0), 1.0, function(1.0), roots);
}

}  // namespace tandem
