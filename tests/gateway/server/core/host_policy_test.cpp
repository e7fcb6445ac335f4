#include "gateway/server/core/host_policy.hpp"

#include <gtest/gtest.h>

namespace tandem::gateway {
namespace {

TEST(HostPolicy, KnowsItsNamesExactly) {
  const HostPolicy policy{{"localhost", "192.168.4.1"}, 8443};
  EXPECT_TRUE(policy.is_our_host("localhost:8443"));
  EXPECT_TRUE(policy.is_our_host("192.168.4.1:8443"));
  for (const char* host :
       {"", "localhost", "localhost:8444", "localhost:8443.evil.org", "evil.org:8443", "LOCALHOST:8443 "}) {
    EXPECT_FALSE(policy.is_our_host(host)) << host;
  }
}

TEST(HostPolicy, OriginMustBeThePageOfTheVeryHost) {
  const HostPolicy policy{{"localhost", "tandem.local"}, 8443};
  EXPECT_TRUE(policy.is_our_origin("https://localhost:8443", "localhost:8443"));
  EXPECT_FALSE(policy.is_our_origin("https://tandem.local:8443", "localhost:8443"));
  EXPECT_FALSE(policy.is_our_origin("http://localhost:8443", "localhost:8443"));
  EXPECT_FALSE(policy.is_our_origin("null", "localhost:8443"));
  EXPECT_FALSE(policy.is_our_origin("", "localhost:8443"));
  EXPECT_FALSE(policy.is_our_origin("https://evil.org", "evil.org"));
}

TEST(CookieValue, IsFoundAmongOthersByItsWholeName) {
  EXPECT_EQ(cookie_value("a=1; __Host-sid=xyz; b=2", "__Host-sid"), "xyz");
  EXPECT_EQ(cookie_value("__Host-sid=xyz", "__Host-sid"), "xyz");
  EXPECT_EQ(cookie_value("x__Host-sid=xyz", "__Host-sid"), "");
  EXPECT_EQ(cookie_value("", "__Host-sid"), "");
  EXPECT_EQ(cookie_value(";;= ;", "__Host-sid"), "");
}

}  // namespace
}  // namespace tandem::gateway
