#pragma once

#include <functional>
#include <string>
#include <vector>

#include "services/bus/bus.hpp"

namespace tandem::cli {

/// Something that is watched on a bus and shown.
struct LiveView {
  std::string title;                                ///< of the live table: "tandem topics"
  std::function<void()> step;                       ///< takes in what came
  std::function<std::vector<std::string>()> lines;  ///< for people; may hold what strangers wrote
  std::function<std::string()> json;                ///< on one line
};

struct LiveViewOptions {
  bool watch = false;  ///< again and again; on a terminal as a live table
  bool json = false;
  double seconds = 3.0;  ///< how long it is watched
  bool endless = false;  ///< until q or Ctrl-C instead
};

/// Watches, and shows it: once at the end, or again and again. Ends in order on Ctrl-C.
void show(const LiveView& view, bus::Bus& bus, const LiveViewOptions& options);

}  // namespace tandem::cli
