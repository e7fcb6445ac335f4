#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace tandem {

/// Direction across the surface at each endpoint [m], in the base frame, by its neighbours in the scan; zero where they
/// form no line. The endpoints are in the order of their beams.
///
/// Of the points close by, those that stray from the line of most are left out. Where a surface is met at a grazing
/// angle its points lie far apart: there the nearest beams make the line, if their gaps grow as on one surface.
[[nodiscard]] std::vector<Eigen::Vector2d> surface_normals(std::span<const Eigen::Vector2d> endpoints_in_base);

}  // namespace tandem
