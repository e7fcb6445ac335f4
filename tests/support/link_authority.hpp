#pragma once

#include <filesystem>
#include <string>

#include "services/common/clock.hpp"
#include "services/relay/link_security.hpp"
#include "services/security/host_files.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::test {

/// An authority of a link, as `tandem secure init` makes it.
class LinkAuthority {
 public:
  LinkAuthority() { security::make_authority(folder_.path(), validity()); }

  /// The folder with the security files of `host`, made now, as by `tandem secure add`.
  [[nodiscard]] std::string files_of(const std::string& host, HostRole role,
                                     const std::string& robot = "robot1") const {
    const LinkTopics topics = link_topics(role);
    return security::make_host_files(folder_.path(), host, {"", robot, topics.publishes, topics.subscribes, validity()})
        .string();
  }

 private:
  static security::Validity validity() {
    const Time now = wall_time();
    return {now - std::chrono::days{1}, now + std::chrono::days{30}};
  }

  TemporaryFolder folder_;
};

}  // namespace tandem::test
