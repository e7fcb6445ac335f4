#include "services/cli/topics_command.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "idl/topics.hpp"
#include "services/cli/command.hpp"
#include "services/cli/host_bus.hpp"
#include "services/cli/live_view.hpp"
#include "services/cli/topics/topics_watch.hpp"

namespace tandem::cli {
namespace {

struct TopicsOptions {
  HostOptions host;
  bool contract = false;
  bool watch = false;
  bool json = false;
  double seconds = 3.0;
};

const char* name_of(Delivery delivery) {
  switch (delivery) {
    case Delivery::SensorStream:
      return "SensorStream";
    case Delivery::State:
      return "State";
    case Delivery::Bulk:
      return "Bulk";
    case Delivery::Command:
      return "Command";
    case Delivery::Event:
      return "Event";
  }
  return "";
}

std::string relayed(const Relay& relay) {
  switch (relay.direction) {
    case Relay::Direction::None:
      return "never";
    case Relay::Direction::ToLaptop:
      return "to laptop";
    case Relay::Direction::ToRobot:
      return "to robot";
    case Relay::Direction::Both:
      return "both";
  }
  return "";
}

void print_contract(bool as_json) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const TopicInfo& topic : all_topics()) {
    const std::string type = topic.make_type()->getName();
    if (as_json) {
      all.push_back({{"topic", topic.name},
                     {"type", type},
                     {"delivery", name_of(topic.delivery)},
                     {"relayed", relayed(topic.relay)},
                     {"max_rate_hz", topic.relay.max_rate_hz}});
    } else {
      std::printf("%-22s %-34s %-13s relayed %s\n", std::string{topic.name}.c_str(), type.c_str(),
                  name_of(topic.delivery), relayed(topic.relay).c_str());
    }
  }
  if (as_json) std::puts(all.dump(2).c_str());
}

void run(const TopicsOptions& options, bool seconds_given) {
  if (options.contract) return print_contract(options.json);
  bus::Bus bus{bus::host_domain(site_of(options.host), "topics")};
  TopicsWatch watch{bus};
  show({.title = "tandem topics",
        .step = [&] { watch.step(); },
        .lines = [&] { return lines_of(watch.view()); },
        .json = [&] { return json_of(watch.view()); }},
       bus,
       {.watch = options.watch,
        .json = options.json,
        .seconds = options.seconds,
        .endless = options.watch && !seconds_given});
}

}  // namespace

void add_topics_command(CLI::App& tandem) {
  const auto options = std::make_shared<TopicsOptions>();
  CLI::App* command = add_command(tandem, "topics",
                                  "Show who writes and reads each topic on this host, how well it arrives, and which "
                                  "peers do wrong",
                                  "tandem topics --watch");
  command->add_flag("--watch", options->watch, "Again and again: as a live table on a terminal, until q or Ctrl-C");
  const auto* seconds =
      command->add_option("--seconds", options->seconds, "How long to watch")->check(CLI::PositiveNumber);
  command->add_flag("--json", options->json, "As JSON; with --watch, a line each time");
  command->add_flag("--contract", options->contract, "List the topics of the contract instead, whoever is there");
  command->add_option("--config", options->host.config_folder, "Folder with site.toml")->capture_default_str();
  command->add_option("--domain", options->host.domain, "DDS domain, instead of the site's");
  command->callback([options, seconds] { run(*options, seconds->count() > 0); });
}

}  // namespace tandem::cli
