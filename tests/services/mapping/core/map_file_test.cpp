#include "services/mapping/core/map_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "services/common/file_io.hpp"
#include "services/common/random.hpp"
#include "tests/support/ascii_map.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem {
namespace {

/// A folder of its own for each test, gone afterwards.
class MapFile : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& content) {
    write_file_atomically(folder_ / name, content);
    return folder_ / name;
  }
  /// What the error says of a map with this YAML text.
  std::string complaint(const std::string& yaml) { return complaint_about(write("m.yaml", yaml)); }
  static std::string complaint_about(const std::filesystem::path& file) {
    try {
      (void)load_map(file, 10'000);
    } catch (const MapError& error) {
      return error.what();
    }
    return "";
  }
  test::TemporaryFolder folder_;
};

const std::string kHeader = "image: m.pgm\nresolution: 0.5\norigin: [-1, 2, 0]\n";

TEST_F(MapFile, ReadsPixelsAsMapServerDoes) {
  write("m.pgm", std::string{"P5\n# drawn by hand\n3 2\n255\n"} + '\0' + '\xfe' + '\xcd' + '\xfe' + '\xfe' + '\0');

  const OccupancyGrid grid = load_map(write("m.yaml", kHeader + "negate: 0\n"));

  // The image's first row is the upper one.
  EXPECT_EQ(grid, test::ascii_map({"#.?", "..#"}, 0.5, {-1.0, 2.0, 0.0}));
}

TEST_F(MapFile, NegatesWhereAsked) {
  write("m.pgm", std::string{"P5 2 1 255\n"} + '\0' + '\xff');

  const OccupancyGrid grid = load_map(write("m.yaml", kHeader + "negate: 1\n"));

  EXPECT_EQ(grid, test::ascii_map({".#"}, 0.5, {-1.0, 2.0, 0.0}));
}

TEST_F(MapFile, GivesBackWhatWasSaved) {
  Rng rng{4};
  OccupancyGrid grid{31, 17, 0.05, {-3.25, 0.1, 0.25}};
  for (CellState& cell : grid.cells()) {
    cell = std::array{CellState::Free, CellState::Occupied, CellState::Unknown}[rng.index(3)];
  }
  save_map(grid, folder_ / "saved.yaml");

  EXPECT_EQ(load_map(folder_ / "saved.yaml"), grid);
}

TEST_F(MapFile, KnowsItsCellsByTheirHash) {
  // printf '\0\144\377' | sha256sum
  const OccupancyGrid grid = test::ascii_map({".#?"});

  EXPECT_EQ(sha256_of_cells(grid).size(), 64U);
  EXPECT_EQ(sha256_of_cells(grid), "93308f0ac1456a39d62795779870c6c651f6621f404ddedc8ed0dd71bb76ae70");
}

TEST_F(MapFile, CorruptMapIsRefusedWithFileAndLine) {
  const std::string yaml = (folder_ / "m.yaml").string();

  write("m.pgm", "P5\n20 20\n255\nshort");
  EXPECT_NE(complaint(kHeader).find(yaml + ":1: image: "), std::string::npos) << complaint(kHeader);
  EXPECT_NE(complaint(kHeader).find("the file ends early"), std::string::npos);

  write("m.pgm", "P5\n100000 100000\n255\n");
  EXPECT_NE(complaint(kHeader).find("the file ends early"), std::string::npos);

  write("m.pgm", "P5\n99999999999999999999 1\n255\n");
  EXPECT_NE(complaint(kHeader).find("absurd"), std::string::npos);

  write("m.pgm", "not an image");
  EXPECT_NE(complaint(kHeader).find("neither a PGM nor a PNG"), std::string::npos);

  write("m.pgm", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\1\x86\xa0\0\1\x86\xa0\b\0\0\0\0", 33));
  EXPECT_NE(complaint(kHeader).find("more than the limit"), std::string::npos) << complaint(kHeader);

  write("m.pgm", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\2\0\0\0\2\b\0\0\0\0", 33));
  EXPECT_NE(complaint(kHeader).find("corrupt"), std::string::npos) << complaint(kHeader);
}

TEST_F(MapFile, CorruptYamlIsRefusedWithFileAndLine) {
  const std::string yaml = (folder_ / "m.yaml").string();
  write("m.pgm", "P5 2 1 255\nab");

  EXPECT_EQ(complaint("image: m.pgm\norigin: [0, 0, 0]\n"), yaml + ":1: resolution is missing");
  EXPECT_EQ(complaint("image: m.pgm\norigin: [0, 0, 0]\nresolution: .nan\n"),
            yaml + ":3: resolution: .nan is not a sensible number");
  EXPECT_EQ(complaint("image: m.pgm\norigin: [0, 0, 0]\nresolution: -1\n"),
            yaml + ":3: resolution: not within [0.001, 100] m");
  EXPECT_EQ(complaint("image: m.pgm\norigin: [0, 0]\nresolution: 1\n"), yaml + ":2: origin: expected [x, y, yaw]");
  EXPECT_EQ(complaint(kHeader + "negate: maybe\n"), yaml + ":4: negate: maybe is not 0 or 1");
  EXPECT_EQ(complaint("just words"), yaml + ":1: not a map file: expected image, resolution, origin");
  EXPECT_NE(complaint("a: [\n").find(yaml + ":"), std::string::npos);
  EXPECT_NE(complaint(std::string(100'000, '[')).find("too long"), std::string::npos);
  EXPECT_NE(complaint(std::string(15'000, '[')), "");
}

TEST_F(MapFile, HugeMapIsRefusedBeforeItIsRead) {
  write("m.pgm", "P5\n200 200\n255\n" + std::string(40'000, 'x'));

  EXPECT_NE(complaint(kHeader).find("200 x 200 cells are more than the limit of 10000"), std::string::npos);
}

TEST_F(MapFile, MissingFilesAreNamed) {
  EXPECT_NE(complaint_about(folder_ / "none.yaml").find("none.yaml: cannot be read"), std::string::npos);
  EXPECT_NE(complaint(kHeader).find("m.pgm: cannot be read"), std::string::npos);
}

}  // namespace
}  // namespace tandem
