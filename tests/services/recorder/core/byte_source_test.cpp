#include "services/recorder/core/byte_source.hpp"

#include <gtest/gtest.h>

#include "services/common/file_io.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::mcap {
namespace {

void expect_abcd(ByteSource& source) {
  EXPECT_EQ(source.size(), 4U);
  EXPECT_EQ(source.read(1, 2), (Bytes{'b', 'c'}));
  EXPECT_EQ(source.read(3, 100), Bytes{'d'});  // fewer at the end
  EXPECT_EQ(source.read(4, 1), Bytes{});
  EXPECT_EQ(source.read(100, 1), Bytes{});
  EXPECT_EQ(source.read(0, 1), Bytes{'a'});  // and back again
}

TEST(ByteSource, OfMemoryGivesItsBytes) {
  expect_abcd(*memory_source({'a', 'b', 'c', 'd'}));
}

TEST(ByteSource, OfAFileGivesTheSame) {
  const test::TemporaryFolder folder;
  const auto file = folder / "bytes";
  write_file_atomically(file, "abcd");
  expect_abcd(*file_source(file));
}

TEST(ByteSource, AFileThatIsNotThereIsNamed) {
  try {
    (void)file_source("no/such.mcap");
    FAIL() << "opened a file that is not there";
  } catch (const McapError& error) {
    EXPECT_EQ(std::string{error.what()}, "no/such.mcap: cannot be opened: No such file or directory");
  }
}

}  // namespace
}  // namespace tandem::mcap
