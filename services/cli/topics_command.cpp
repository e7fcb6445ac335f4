#include "services/cli/topics_command.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "idl/topics.hpp"
#include "services/cli/command.hpp"

namespace tandem::cli {
namespace {

struct TopicsOptions {
  bool json = false;
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

void run(const TopicsOptions& options) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const TopicInfo& topic : all_topics()) {
    const std::string type = topic.make_type()->getName();
    if (options.json) {
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
  if (options.json) std::puts(all.dump(2).c_str());
}

}  // namespace

void add_topics_command(CLI::App& tandem) {
  const auto options = std::make_shared<TopicsOptions>();
  CLI::App* command = add_command(tandem, "topics", "List every topic of the contract", "tandem topics --json");
  command->add_flag("--json", options->json, "As JSON");
  command->callback([options] { run(*options); });
}

}  // namespace tandem::cli
