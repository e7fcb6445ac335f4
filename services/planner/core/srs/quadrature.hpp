#pragma once

#include <array>
#include <cmath>

namespace tandem {
namespace detail {

// Abscissae and weights of the 15-point Kronrod rule and of the 7-point Gauss rule in it, for [-1, 1]
// (QUADPACK, Piessens et al. 1983, public domain).
inline constexpr std::array<double, 8> kKronrodPoints{
    0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
    0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
    0.586087235467691130294144691693013, 0.405845151377397166906606412076961,
    0.207784955007898467600689403773245, 0.0};
inline constexpr std::array<double, 8> kKronrodWeights{
    0.022935322010529224963732008058970, 0.063092092629978553290700663189204, 0.104790010322250183839876322541518,
    0.140653259715525918745189590510238, 0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
    0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
inline constexpr std::array<double, 4> kGaussWeights{
    0.129484966168869693270611432679082, 0.279705391489276667901467771423780, 0.381830050505118944950369775488975,
    0.417959183673469387755102040816327};

template <typename Function>
double integral_to(const Function& function, double from, double to, double tolerance, int depth) {
  const double middle = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  double kronrod = kKronrodWeights[7] * function(middle);
  double gauss = kGaussWeights[3] * kronrod / kKronrodWeights[7];
  for (std::size_t i = 0; i < 7; ++i) {
    const double pair = function(middle - half * kKronrodPoints[i]) + function(middle + half * kKronrodPoints[i]);
    kronrod += kKronrodWeights[i] * pair;
    if (i % 2 == 1) gauss += kGaussWeights[i / 2] * pair;
  }
  if (depth == 0 || std::abs(kronrod - gauss) * half <= tolerance) return kronrod * half;
  return integral_to(function, from, middle, 0.5 * tolerance, depth - 1) +
         integral_to(function, middle, to, 0.5 * tolerance, depth - 1);
}

}  // namespace detail

/// The integral of `function` from `from` to `to`, by the adaptive Gauss-Kronrod rule.
///
/// The estimated error is below `tolerance`, but where 40 bisections are not enough (a jump): there about 1e-12 of the
/// interval is uncertain. Smooth functions take 15 evaluations.
template <typename Function>
[[nodiscard]] double integral(const Function& function, double from, double to, double tolerance) {
  constexpr int kBisections = 40;
  return to > from ? detail::integral_to(function, from, to, tolerance, kBisections) : 0.0;
}

}  // namespace tandem
