#include "services/cli/status/status_watch.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "tests/support/domain_lease.hpp"

namespace tandem::cli {
namespace {

using std::chrono::seconds;

TEST(StatusWatch, HearsTheTeamAndThatAServiceIsGone) {
  const test::DomainLease domain{1};
  SiteConfig site;
  site.host = "laptop1";
  site.host_domain = domain[0];
  bus::Bus ours{bus::host_domain(site, "status")};
  const StatusWatch watch{ours, site};
  auto theirs = std::make_unique<bus::Bus>(bus::host_domain(site, "base"));
  auto health = std::make_unique<bus::Writer<msg::ServiceHealth, msg::ServiceHealthPubSubType>>(
      theirs->writer(topic::kServiceHealth));
  auto base = theirs->writer(topic::kBaseStatus);
  msg::ServiceHealth well;
  well.host("robot1");
  well.service("base");
  well.state(msg::HEALTH_OK);
  health->write(well);
  msg::BaseStatus status;
  status.robot("robot1");
  status.connected(true);
  status.stop_reasons({msg::STOP_BUMPER});
  base.write(status);
  status.robot("robot2");  // of another team
  status.stop_reasons({});
  base.write(status);

  ASSERT_TRUE(bus::wait_until(ours, seconds{20}, [&] {
    const auto seen = watch.status();
    return seen.services.size() == 1 && seen.robot_status.has_value();
  }));
  EXPECT_EQ(watch.status().services[0].state, "ok");
  EXPECT_EQ(watch.status().robot_status->stop_reasons.size(), 1U);
  EXPECT_FALSE(watch.status().link);

  health.reset();
  EXPECT_TRUE(bus::wait_until(ours, seconds{20}, [&] { return watch.status().services[0].state == "gone"; }));
}

}  // namespace
}  // namespace tandem::cli
