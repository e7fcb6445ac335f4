#include "services/recorder/core/mcap_copy.hpp"

#include <gtest/gtest.h>

#include "tests/services/recorder/core/mcap_files.hpp"

namespace tandem::mcap {
namespace {

TEST(McapCopy, CompactionKeepsEverything) {
  Reader live = opened(live_file(20, false));
  Bytes bytes;
  IndexedWriter writer{into(bytes), {"", "test"}, 200};
  ASSERT_TRUE(copy(live, writer));
  ASSERT_TRUE(writer.finish());
  Reader reader = opened(bytes);
  expect_all(reader, 20);
  EXPECT_EQ(reader.metadata().size(), 1U);
  EXPECT_EQ(reader.attachments().size(), 1U);
  EXPECT_TRUE(reader.complete());
}

}  // namespace
}  // namespace tandem::mcap
