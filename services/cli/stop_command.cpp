#include "services/cli/stop_command.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <tuple>

#include "services/bus/bus.hpp"
#include "services/bus/events.hpp"
#include "services/cli/command.hpp"
#include "services/cli/host_bus.hpp"

namespace tandem::cli {
namespace {

struct StopOptions {
  HostOptions host;
  std::string robot;  ///< empty: the site's
  bool everywhere = false;
  bool is_clear = false;
};

/// Whoever can run this on the host could also switch it off: the press of a button counts as held.
constexpr std::uint32_t kHeldMs = 1000;

constexpr Duration kMeeting = std::chrono::seconds{2};

/// Sends `event` until the base has answered. Throws std::runtime_error when it does not or will not.
template <class Topic, class Event>
void deliver(bus::Bus& bus, const Topic& topic, const Event& event, const std::string& what) {
  bus::EventSender sender{bus, topic};
  // What is sent before the base is met is lost, and would be repeated a second later.
  std::ignore = bus::wait_until(bus, kMeeting, [&] { return sender.is_heard() || stop_requested(); });
  sender.send(event);
  bus::EventOutcome outcome = sender.outcome(event.id());
  for (; outcome.state == bus::EventOutcome::State::Pending; outcome = sender.outcome(event.id())) {
    if (stop_requested()) throw Interrupted();
    bus.wait(std::chrono::milliseconds{20});
    sender.step();
  }
  if (outcome.state == bus::EventOutcome::State::Refused) {
    throw std::runtime_error(what + " refused by " + outcome.by + ": " + outcome.reason);
  }
  if (outcome.state == bus::EventOutcome::State::Undelivered) {
    throw std::runtime_error(what + " NOT delivered: no base answered. Use the emergency stop");
  }
  std::printf("%s delivered\n", what.c_str());
}

std::string sender_name() {
  const char* user = ::getlogin();
  return std::string{"cli:"} + (user != nullptr ? user : std::to_string(::getuid()));
}

void stop(const StopOptions& options) {
  std::ignore = stop_requested();  // from now on Ctrl-C ends it in order
  const SiteConfig site = site_of(options.host);
  bus::Bus bus{bus::host_domain(site, "stop")};
  msg::StopRequest request;
  if (!options.everywhere) request.robot(options.robot.empty() ? site.robot : options.robot);
  request.id(bus::new_event_id(sender_name(), bus.clock()));
  request.stamp_ns(to_stamp_ns(bus.clock().now()));
  request.who(sender_name());
  request.latched(true);
  deliver(bus, topic::kStopRequest, request, "STOP");
}

void resume(const StopOptions& options) {
  std::ignore = stop_requested();
  if (!options.is_clear) throw WrongUse("look at the robot first; then say --clear: nobody is in its way");
  const SiteConfig site = site_of(options.host);
  bus::Bus bus{bus::host_domain(site, "resume")};
  msg::ResumeRequest request;
  request.robot(options.robot.empty() ? site.robot : options.robot);
  request.id(bus::new_event_id(sender_name(), bus.clock()));
  request.stamp_ns(to_stamp_ns(bus.clock().now()));
  request.who(sender_name());
  request.held_ms(kHeldMs);
  deliver(bus, topic::kResumeRequest, request, "resume");
}

CLI::App* add(CLI::App& tandem, StopOptions& options, const std::string& name, const std::string& purpose,
              const std::string& example) {
  CLI::App* command = add_command(tandem, name, purpose, example);
  command->add_option("--robot", options.robot, "Its name; default: the site's robot");
  command->add_option("--config", options.host.config_folder, "Folder with site.toml")->capture_default_str();
  command->add_option("--domain", options.host.domain, "DDS domain, instead of the site's");
  return command;
}

}  // namespace

void add_stop_commands(CLI::App& tandem) {
  const auto options = std::make_shared<StopOptions>();
  CLI::App* stopping = add(tandem, *options, "stop", "Stop the robot until somebody resumes, and say whether it heard",
                           "tandem stop --all");
  stopping->add_flag("--all", options->everywhere, "Every robot that hears it");
  stopping->callback([options] { stop(*options); });

  const auto to_resume = std::make_shared<StopOptions>();
  CLI::App* resuming =
      add(tandem, *to_resume, "resume", "Let a stopped robot move again, after its warning", "tandem resume --clear");
  resuming->add_flag("--clear", to_resume->is_clear, "You have looked: nobody and nothing is in its way");
  resuming->callback([to_resume] { resume(*to_resume); });
}

}  // namespace tandem::cli
