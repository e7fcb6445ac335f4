#include "gateway/net/page_files.hpp"

#include <gtest/gtest.h>

namespace tandem::net {
namespace {

const std::vector<Asset>& files() {
  static const std::vector<Asset> all{{"/index.html", "text/html", "page", false},
                                      {"/assets/index-1a2b.js", "text/javascript", "code", true}};
  return all;
}

TEST(PageFiles, TheRootAndThePairingLinkAreThePage) {
  const PageFiles pages{files()};
  for (const auto* target : {"/", "/p", "/p?x=1", "/index.html"}) {
    ASSERT_NE(pages.find(target), nullptr) << target;
    EXPECT_EQ(pages.find(target)->content, "page") << target;
  }
}

TEST(PageFiles, NothingElseIsFound) {
  const PageFiles pages{files()};
  for (const auto* target : {"", "/pp", "/assets/", "/assets/../index.html", "/ws"}) {
    EXPECT_EQ(pages.find(target), nullptr) << target;
  }
}

TEST(PageFiles, OnlyAFileWhoseNameCarriesAHashNeverChanges) {
  const PageFiles pages{files()};
  EXPECT_TRUE(pages.is_immutable("/assets/index-1a2b.js"));
  EXPECT_FALSE(pages.is_immutable("/"));
  EXPECT_FALSE(pages.is_immutable("/absent"));
}

}  // namespace
}  // namespace tandem::net
