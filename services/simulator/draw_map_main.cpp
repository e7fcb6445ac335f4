#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

#include "services/common/file_io.hpp"
#include "services/mapping/core/map_file.hpp"
#include "services/simulator/core/map_plan.hpp"

/// tandem-draw-map PLAN.plan.json MAP.yaml: draws a vector plan as a map_server map (YAML and PGM beside it).
int main(int argc, char** argv) try {
  if (argc != 3) {
    std::cerr << "Draws a vector plan as a map.\nUsage: tandem-draw-map PLAN.plan.json MAP.yaml\n"
                 "Example: tandem-draw-map config/maps/brl.plan.json config/maps/brl.yaml\n";
    return argc == 2 && std::string{argv[1]} == "--help" ? EXIT_SUCCESS : 2;
  }
  const std::filesystem::path plan_file = argv[1];
  const std::filesystem::path yaml_file = argv[2];
  const auto map =
      tandem::simulator::draw(tandem::simulator::parse_map_plan(tandem::read_file(plan_file), plan_file.string()));
  tandem::save_map(map, yaml_file);
  std::cout << yaml_file.string() << ": " << map.width() << " x " << map.height() << " cells, "
            << tandem::simulator::free_area_m2(map) << " m2 free\n";
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::cerr << "tandem-draw-map: " << error.what() << "\n";
  return EXIT_FAILURE;
}
