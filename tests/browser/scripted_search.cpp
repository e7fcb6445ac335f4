// Writes the recording of a search by hand. usage: scripted_search OUTPUT.mcap
#include <cstdlib>
#include <exception>
#include <iostream>

#include "services/recorder/recording_file.hpp"
#include "tests/services/cli/report/scripted_recording.hpp"

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "usage: scripted_search OUTPUT.mcap\n";
    return 2;
  }
  constexpr double kBegan_s = 1.7e9;
  tandem::recorder::write_recording(
      argv[1], [](tandem::mcap::Writer& writer) { tandem::test::write_scripted_search(writer, "scripted", kBegan_s); });
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::cerr << "scripted_search: " << error.what() << "\n";
  return EXIT_FAILURE;
}
