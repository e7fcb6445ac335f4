#include "services/cli/up/config_text.hpp"

#include <gtest/gtest.h>

namespace tandem::cli {
namespace {

TEST(ConfigText, ReplacesTheLineOfAKeyAndKeepsTheRest) {
  EXPECT_EQ(with_value("# hosts\nhost = \"a\"  # ours\nport = 1\n", "port", "2"),
            "# hosts\nhost = \"a\"  # ours\nport = 2\n");
}

TEST(ConfigText, AddsAKeyThatIsNotThere) { EXPECT_EQ(with_value("a = 1\n", "b", "2"), "a = 1\nb = 2\n"); }

TEST(ConfigText, DoesNotTakeALongerKeyOrACommentForTheKey) {
  EXPECT_EQ(with_value("port_range = 1\n# port = 3\n", "port", "2"), "port_range = 1\n# port = 3\nport = 2\n");
}

TEST(ConfigText, QuotesWhatTomlNeedsQuoted) { EXPECT_EQ(toml_string("a\"b\\c"), "\"a\\\"b\\\\c\""); }

}  // namespace
}  // namespace tandem::cli
