#include "services/cli/live_view.hpp"

#include <cstdio>
#include <tuple>

#include "services/cli/command.hpp"
#include "services/cli/live_terminal.hpp"

namespace tandem::cli {
namespace {

constexpr Duration kDrawPeriod = std::chrono::milliseconds{500};  // on a terminal
constexpr Duration kTellPeriod = std::chrono::seconds{2};         // elsewhere
constexpr Duration kStep = std::chrono::milliseconds{50};

void print(const LiveView& view, bool as_json) {
  if (as_json) {
    std::puts(view.json().c_str());
  } else {
    for (const auto& line : view.lines()) std::puts(printable(line).c_str());
  }
  std::fflush(stdout);
}

void draw_until_quit(const LiveView& view, const std::function<bool()>& is_over) {
  LiveTerminal terminal;
  do {
    view.step();
    std::vector<std::string> lines{view.title + ": q ends it", ""};
    for (const auto& line : view.lines()) lines.push_back(printable(line));
    terminal.draw(lines);
    const auto keys = terminal.keys(kDrawPeriod);
    if (!keys || keys->find_first_of("qQ") != std::string::npos) return;
  } while (!is_over());
}

void tell_again_and_again(const LiveView& view, bus::Bus& bus, bool as_json, const std::function<bool()>& is_over) {
  for (Time next = bus.clock().now() + kTellPeriod; !is_over(); bus.wait(kStep)) {
    view.step();
    if (bus.clock().now() < next) continue;
    print(view, as_json);
    if (!as_json) std::puts("");
    next += kTellPeriod;
  }
}

}  // namespace

void show(const LiveView& view, bus::Bus& bus, const LiveViewOptions& options) {
  std::ignore = stop_requested();  // from now on Ctrl-C ends it in order
  const Time began = bus.clock().now();
  const auto is_over = [&] {
    return stop_requested() || (!options.endless && bus.clock().now() - began >= from_seconds(options.seconds));
  };
  if (options.watch && !options.json && LiveTerminal::is_there()) return draw_until_quit(view, is_over);
  if (options.watch) return tell_again_and_again(view, bus, options.json, is_over);
  while (!is_over()) {
    bus.wait(kStep);
    view.step();
  }
  print(view, options.json);
}

}  // namespace tandem::cli
