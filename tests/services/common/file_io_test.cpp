#include "services/common/file_io.hpp"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace tandem {
namespace {

class FileIo : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
};

TEST_F(FileIo, GivesBackEveryByte) {
  const std::string content{"one\n\0two\r\n\xFF", 11};

  write_file_atomically(folder_ / "bytes", content);

  EXPECT_EQ(read_file(folder_ / "bytes"), content);
}

TEST_F(FileIo, ReplacesTheOldContentAndLeavesNothingBeside) {
  write_file_atomically(folder_ / "note", "a long first text");
  write_file_atomically(folder_ / "note", "short");

  EXPECT_EQ(read_file(folder_ / "note"), "short");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator{folder_.path()}, {}), 1);
}

TEST_F(FileIo, AFileThatCannotBeReadIsNamedWithTheReason) {
  try {
    (void)read_file(folder_ / "absent");
    FAIL() << "read an absent file";
  } catch (const FileError& error) {
    EXPECT_EQ(std::string{error.what()}, (folder_ / "absent").string() + ": cannot be read: No such file or directory");
  }
}

TEST_F(FileIo, AFileThatCannotBeWrittenIsNamedAndNothingIsLeftHalfWritten) {
  std::filesystem::create_directory(folder_ / "taken");  // a folder stands where the file is to go

  try {
    write_file_atomically(folder_ / "taken", "text");
    FAIL() << "wrote over a folder";
  } catch (const FileError& error) {
    EXPECT_TRUE(std::string{error.what()}.starts_with((folder_ / "taken").string() + ": cannot be written: "));
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "taken.part"));
  EXPECT_TRUE(std::filesystem::is_directory(folder_ / "taken"));
}

TEST_F(FileIo, AFolderThatDoesNotExistIsSaid) {
  EXPECT_THROW(write_file_atomically(folder_ / "absent" / "note", "text"), FileError);
}

}  // namespace
}  // namespace tandem
