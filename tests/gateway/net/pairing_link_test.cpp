#include "gateway/net/pairing_link.hpp"

#include <gtest/gtest.h>

namespace tandem::net {
namespace {

TEST(PairingLink, IsReadAsItIsWritten) {
  const PairingLink link{"tandem.local", 8443, "0123abcd", "fedcba9876543210"};
  EXPECT_EQ(to_string(link), "https://tandem.local:8443/p#t=0123abcd&fp=fedcba9876543210");
  EXPECT_EQ(parse_pairing_link(to_string(link)), link);
  EXPECT_EQ(parse_pairing_link(" " + to_string(link) + "\n"), link);
}

TEST(PairingLink, RefusesWhatIsNone) {
  for (const char* text :
       {"", "http://a:1/p#t=1&fp=2", "https://a/p#t=1&fp=2", "https://a:0/p#t=1&fp=2", "https://a:70000/p#t=1&fp=2",
        "https://a:1/p#t=&fp=2", "https://a:1/p#t=1&fp=", "https://a:1/p#t=1\"&fp=2", "https://:1/p#t=1&fp=2"}) {
    EXPECT_FALSE(parse_pairing_link(text)) << text;
  }
}

}  // namespace
}  // namespace tandem::net
