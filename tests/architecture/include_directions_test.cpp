#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "tests/architecture/source_tree.hpp"

namespace tandem::test {
namespace {

/// Who may include whom; the row with the longest matching folder holds. A new folder is a new row.
/// "*/core" in the right column stands for every core.
struct Row {
  std::string folder;
  std::vector<std::string> may_include;
};

const std::vector<std::string> kCore{"services/common/", "services/mapping/core/"};
const std::vector<std::string> kShell{"services/common/", "services/bus/", "idl/", "services/mapping/core/",
                                      "services/mapping/map_messages.hpp"};

std::vector<std::string> with(std::vector<std::string> list, const std::vector<std::string>& more) {
  list.insert(list.end(), more.begin(), more.end());
  return list;
}

const std::vector<Row>& rows() {
  static const std::vector<Row> table{
      {"idl/", {"idl/"}},
      {"services/common/", {"services/common/"}},
      {"services/bus/core/", {"services/common/", "services/bus/core/"}},
      {"services/security/", {"services/common/", "services/security/"}},
      {"services/bus/", {"services/common/", "services/bus/", "idl/"}},
      {"services/mapping/core/", kCore},
      {"services/mapping/", with(kShell, {"services/mapping/"})},
      {"services/localization/core/", with(kCore, {"services/localization/core/"})},
      {"services/localization/", with(kShell, {"services/localization/"})},
      // Builds maps with localization's searches and measures (decision 9).
      {"services/map_builder/core/", with(kCore, {"services/map_builder/core/", "services/localization/core/"})},
      {"services/tracking/core/", with(kCore, {"services/tracking/core/"})},
      {"services/tracking/", with(kShell, {"services/tracking/"})},
      {"services/planner/core/", with(kCore, {"services/planner/core/"})},
      {"services/planner/remote/", with(kCore, {"services/planner/core/", "services/planner/remote/"})},
      {"services/planner/", with(kShell, {"services/planner/"})},
      {"services/navigator/core/", with(kCore, {"services/navigator/core/"})},
      {"services/navigator/", with(kShell, {"services/navigator/"})},
      {"services/relay/core/", with(kCore, {"services/relay/core/"})},
      {"services/relay/", with(kShell, {"services/relay/", "services/security/"})},
      {"services/recorder/core/", with(kCore, {"services/recorder/core/"})},
      {"services/recorder/", with(kShell, {"services/recorder/"})},
      // The simulated hardware speaks the drivers' own wire formats and sees through the same camera.
      {"services/simulator/core/",
       with(kCore, {"services/simulator/core/", "robot/pioneer/core/", "robot/laser/core/", "robot/camera/core/"})},
      {"services/simulator/", with(kShell, {"services/simulator/", "robot/pioneer/core/", "robot/laser/core/",
                                            "robot/camera/core/", "gateway/net/", "gateway/protocol/"})},
      {"services/experiment/", with(kCore, {"services/experiment/", "*/core/"})},
      // Calibration writes what the base reads.
      {"services/cli/", {"services/", "*/core/", "idl/", "gateway/", "calibration/", "robot/pioneer/base_config.hpp"}},
      {"robot/link/", {"robot/link/", "services/common/"}},
      {"robot/safety/core/", {"robot/safety/core/", "services/common/"}},
      {"robot/pioneer/core/", with(kCore, {"robot/pioneer/core/"})},
      // The base is where the gate sits: one process, the last thing before the wheels.
      {"robot/pioneer/", with(kShell, {"robot/pioneer/", "robot/safety/core/", "robot/link/"})},
      {"robot/laser/core/", with(kCore, {"robot/laser/core/"})},
      {"robot/laser/", with(kShell, {"robot/laser/", "robot/link/"})},
      {"robot/camera/core/", with(kCore, {"robot/camera/core/"})},
      {"robot/camera/", with(kShell, {"robot/camera/"})},
      {"gateway/net/", {"gateway/net/", "services/common/", "services/security/"}},
      {"gateway/protocol/", {"gateway/protocol/", "services/common/"}},
      {"gateway/server/core/", with(kCore, {"gateway/server/core/", "gateway/protocol/"})},
      {"gateway/server/", with(kShell, {"gateway/"})},
      // What Vite built, as a table of texts.
      {"gateway/web/", {"gateway/net/"}},
      {"calibration/", with(kCore, {"calibration/", "*/core/"})},
      // The base's service between the bus and a simulated controller.
      {"bench/base/", with(kShell, {"bench/", "robot/pioneer/core/", "services/simulator/", "tests/support/"})},
      // Both sides of the link in a laboratory: ours through relays and bus, the peer through Fast DDS itself.
      {"bench/network/", with(kShell, {"bench/", "services/relay/", "tests/network/", "tests/support/"})},
      // The recorder under load: ourselves on its bus, and its files.
      {"bench/recording/", with(kShell, {"bench/", "services/recorder/", "tests/support/"})},
      {"bench/", with(kCore, {"bench/", "*/core/", "services/planner/remote/"})},
  };
  return table;
}

const Row* row_of(const std::string& file) {
  const Row* best = nullptr;
  for (const auto& row : rows()) {
    if (file.starts_with(row.folder) && (best == nullptr || row.folder.size() > best->folder.size())) best = &row;
  }
  return best;
}

bool is_allowed(const std::vector<std::string>& may_include, const std::string& included) {
  return std::any_of(may_include.begin(), may_include.end(), [&](const std::string& allowed) {
    return included.starts_with(allowed) || (allowed == "*/core/" && included.find("/core/") != std::string::npos);
  });
}

TEST(IncludeDirections, EveryIncludeOfOursFollowsTheTable) {
  const std::regex include{R"re(^#include "([^"]+)")re"};
  for (const auto& line : lines_of_sources({"idl", "services", "robot", "gateway", "calibration", "bench"})) {
    const Row* row = row_of(line.file);
    ASSERT_NE(row, nullptr) << line.file << " lies in a folder that has no row in include_directions_test.cpp";
    std::smatch match;
    if (!std::regex_search(line.text, match, include)) continue;
    EXPECT_TRUE(is_allowed(row->may_include, match[1]))
        << line.file << ":" << line.number << ": " << row->folder << " must not include " << match[1];
  }
}

TEST(IncludeDirections, IncludesAreWrittenFromTheRootOfTheRepository) {
  const std::regex include{R"re(^#include "([^"]+)")re"};
  for (const auto& line : lines_of_sources({"idl", "services", "robot", "gateway", "calibration", "bench", "tests"})) {
    std::smatch match;
    if (!std::regex_search(line.text, match, include)) continue;
    EXPECT_NE(match[1].str().find('/'), std::string::npos) << line.file << ":" << line.number << ": " << line.text;
    EXPECT_EQ(match[1].str().find(".."), std::string::npos) << line.file << ":" << line.number << ": " << line.text;
  }
}

}  // namespace
}  // namespace tandem::test
