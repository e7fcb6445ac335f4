#pragma once

#include <string>
#include <vector>

#include "services/common/security_files.hpp"
#include "services/common/time.hpp"

namespace tandem::security {

/// What the files of a host must fit.
struct Expected {
  std::string host;   ///< site.toml
  std::string robot;  ///< its team
  int domain = 0;     ///< of the link
  std::vector<std::string> publishes;
  std::vector<std::string> subscribes;
};

/// Why Fast DDS would not take `files`, or would take them and then stay silent; empty if it will work.
///
/// To be asked before a participant is made: Fast DDS keeps most of this to itself. Each says what is wrong, where, and
/// what to do. `now` is of the wall clock, by which Fast DDS judges.
[[nodiscard]] std::vector<std::string> problems_of(const SecurityFiles& files, const Expected& expected, Time now);

/// When the first of the certificates and permissions ends. Throws std::runtime_error; problems_of() says why.
[[nodiscard]] Time end_of(const SecurityFiles& files);

}  // namespace tandem::security
