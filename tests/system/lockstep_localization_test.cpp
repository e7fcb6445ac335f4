// The live service, fed in lockstep, finds the very poses that `tandem localize` finds offline.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

#include "services/common/file_io.hpp"
#include "services/recorder/core/carmen_log.hpp"
#include "tests/support/domain_lease.hpp"
#include "tests/support/process.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_data.hpp"

namespace tandem::test {
namespace {

namespace fs = std::filesystem;

const std::string kBin = TANDEM_BINARY_DIR "/bin/";

int run(const std::string& command) {
  return WEXITSTATUS(std::system(command.c_str()));
}

/// The lines of fr079 up to `end_s`.
std::string first_seconds_of_fr079(double end_s) {
  std::istringstream all{carmen::read_log_file((data_folder() / "fr079/fr079.odomscan.txt.gz").string())};
  std::string kept;
  for (std::string line; std::getline(all, line);) {
    if (!line.starts_with('#') && std::stod(line.substr(2)) > end_s) break;
    kept += line + "\n";
  }
  return kept;
}

class LockstepLocalization : public testing::Test {
 protected:
  void prepare() {
    fs::create_directories(folder_ / "config");
    write_file_atomically(folder_ / "log.txt", first_seconds_of_fr079(60.0));
    write_file_atomically(folder_ / "config/site.toml", "host_domain = " + std::to_string(domain_[0]) + "\n");
    write_file_atomically(folder_ / "config/map-server.toml", "map = \"" + map_ + "\"\n");
    write_file_atomically(folder_ / "config/localization.toml",
                          "seed = 7\nscans = \"odd\"\nstart = [0.001236, -0.001068, 0.000029]\n");
    ASSERT_EQ(run(kBin + "tandem import carmen " + path("log.txt") + " -o " + path("log.mcap")), 0);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

  const DomainLease domain_{1};
  const TemporaryFolder folder_;
  const std::string map_ = fs::absolute(data_folder() / "maps/fr079_even.yaml").string();
};

TEST_F(LockstepLocalization, GivesTheTrajectoryOfTandemLocalizeByteForByte) {
  TANDEM_NEEDS_DATA("fr079/fr079.odomscan.txt.gz");
  prepare();
  ASSERT_EQ(run(kBin + "tandem localize " + path("log.mcap") + " --map " + map_ + " --config " +
                path("config/localization.toml") + " --trajectory " + path("offline.txt")),
            0);
  {
    const Process maps{{kBin + "tandem-map-server", "--config", path("config"), "--lockstep"}};
    const Process localization{{kBin + "tandem-localization", "--config", path("config"), "--lockstep"}};
    ASSERT_EQ(run(kBin + "tandem replay " + path("log.mcap") + " --lockstep --config " + path("config") +
                  " --trajectory " + path("live.txt")),
              0);
  }
  const std::string offline = read_file(folder_ / "offline.txt");
  EXPECT_GT(offline.size(), 4'000U);
  EXPECT_EQ(read_file(folder_ / "live.txt"), offline);
}

}  // namespace
}  // namespace tandem::test
