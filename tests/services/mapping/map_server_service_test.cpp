#include "services/mapping/map_server_service.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "services/mapping/core/map_file.hpp"
#include "services/mapping/map_messages.hpp"
#include "tests/support/ascii_map.hpp"
#include "tests/support/domain_lease.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem {
namespace {

OccupancyGrid room() {
  return test::ascii_map({"###", "#.?", "###"}, 0.25, {1.0, 2.0, 0.5});
}

TEST(MapMessages, CarryAMapThereAndBack) {
  const msg::OccupancyGrid message = to_message(room(), "room");

  EXPECT_EQ(message.map_id(), "room");
  EXPECT_EQ(message.sha256(), sha256_of_cells(room()));
  EXPECT_EQ(to_grid(message), room());
}

TEST(MapMessages, RefuseWhatDoesNotFitTogether) {
  msg::OccupancyGrid damaged = to_message(room(), "room");
  damaged.cells()[4] = 100;
  EXPECT_FALSE(to_grid(damaged));

  msg::OccupancyGrid cut = to_message(room(), "room");
  cut.width(4);
  EXPECT_FALSE(to_grid(cut));

  msg::OccupancyGrid flat = to_message(room(), "room");
  flat.resolution_m(0.0);
  EXPECT_FALSE(to_grid(flat));
}

TEST(MapServerService, GivesItsMapToThoseWhoComeLater) {
  const test::TemporaryFolder folder;
  save_map(room(), folder / "room.yaml");
  const test::DomainLease domain{1};
  SiteConfig site;
  site.host_domain = domain[0];
  bus::Bus bus{bus::host_domain(site, "map-server")};
  MapServerService service{MapServerConfig{.map = "room.yaml"}, folder.path(), site, bus};

  bus::Bus late{bus::host_domain(site, "late")};
  auto maps = late.latest(topic::kMap);

  ASSERT_TRUE(bus::wait_until(late, from_seconds(20.0), [&] { return maps.newest().has_value(); }));
  EXPECT_EQ(maps.newest()->message.map_id(), "room");
  EXPECT_EQ(to_grid(maps.newest()->message), room());
}

TEST(MapServerService, CorruptMapIsRefused) {
  const test::DomainLease domain{1};
  SiteConfig site;
  site.host_domain = domain[0];
  bus::Bus bus{bus::host_domain(site, "map-server")};

  EXPECT_THROW(MapServerService(MapServerConfig{.map = "none.yaml"}, "/tmp", site, bus), MapError);
}

}  // namespace
}  // namespace tandem
