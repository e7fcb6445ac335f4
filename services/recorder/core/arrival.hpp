#pragma once

#include <cstddef>

#include "services/common/time.hpp"
#include "services/recorder/core/disposed_record.hpp"

namespace tandem::recorder {

/// A sample, or the end of an instance, as it came to the recorder.
struct Arrival {
  std::size_t source = 0;  ///< number of its topic
  bool disposed = false;   ///< the instance has ended; there is no payload
  mcap::Bytes payload;
  KeyBytes key{};
  Time received{};     ///< this host's mission time
  Time source_time{};  ///< stamped by the writer, its host's clock
};

}  // namespace tandem::recorder
