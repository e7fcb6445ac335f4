#include "bench/network/campaign.hpp"

#include <gtest/gtest.h>

#include <set>

#include "bench/network/airs.hpp"

namespace tandem::bench {
namespace {

TEST(NetworkCampaign, PutsOursBesideTheDefaultInEveryAirAndRun) {
  std::set<NetworkKey> keys;
  for (const auto& request : network_campaign(5, false)) EXPECT_TRUE(keys.insert(request.key).second);
  for (const auto& request : network_campaign(5, false)) {
    auto key = request.key;
    EXPECT_GE(key.run, 1);
    EXPECT_LE(key.run, 5);
    if (request.alone) continue;  // a whole team is ours alone
    key.whose = key.whose == "ours" ? "default" : "ours";
    EXPECT_TRUE(keys.contains(key)) << key.text();
  }
}

TEST(NetworkCampaign, KnowsEveryAirThatItNames) {
  for (const auto& request : network_campaign(1, false)) EXPECT_NO_THROW(std::ignore = conditions_of(request.key.air));
}

TEST(NetworkCampaign, AQuickOneIsAPartOfTheWhole) {
  std::set<NetworkKey> whole;
  for (const auto& request : network_campaign(1, false)) whole.insert(request.key);
  const auto quick = network_campaign(1, true);
  EXPECT_LT(quick.size(), whole.size());
  for (const auto& request : quick) EXPECT_TRUE(whole.contains(request.key)) << request.key.text();
}

}  // namespace
}  // namespace tandem::bench
