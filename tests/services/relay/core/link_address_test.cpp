#include "services/relay/core/link_address.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

const std::vector<InterfaceAddress> kPresent{
    {"lo", "127.0.0.1"}, {"wlan0", "10.0.0.5"}, {"wlan0", "10.0.0.6"}, {"eth0", "192.168.1.2"}};

TEST(LinkAddress, IsTheFirstOfTheInterfaceThatIsNamed) {
  EXPECT_EQ(link_address("wlan0", kPresent, std::nullopt), "10.0.0.5");
  EXPECT_EQ(link_address("wlan1", kPresent, std::nullopt), std::nullopt);
}

TEST(LinkAddress, IsTheAddressThatIsGivenWhereItIsThere) {
  EXPECT_EQ(link_address("192.168.1.2", kPresent, std::nullopt), "192.168.1.2");
  EXPECT_EQ(link_address("192.168.1.3", kPresent, std::nullopt), std::nullopt);
}

TEST(LinkAddress, IsKeptAsLongAsItIsThere) {
  EXPECT_EQ(link_address("wlan0", kPresent, "10.0.0.6"), "10.0.0.6");
  EXPECT_EQ(link_address("wlan0", kPresent, "10.0.0.9"), "10.0.0.5");  // a new lease
}

TEST(LinkAddress, OfAnotherInterfaceIsNotKept) {
  EXPECT_EQ(link_address("wlan0", kPresent, "192.168.1.2"), "10.0.0.5");
}

}  // namespace
}  // namespace tandem
