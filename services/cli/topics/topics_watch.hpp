#pragma once

#include <memory>
#include <string>
#include <vector>

#include "services/bus/bus.hpp"
#include "services/bus/core/service_roster.hpp"
#include "services/cli/topics/topic_ledger.hpp"

namespace tandem::cli {

/// Reads every topic of a host domain, and hears who is in it.
class TopicsWatch {
 public:
  explicit TopicsWatch(bus::Bus& bus);

  /// Takes in what came; to be called some times a second.
  void step();
  [[nodiscard]] TopicsView view();

 private:
  struct Feed {
    std::string topic;
    bool latched;
    std::shared_ptr<bus::InOrderBox> box;  // shared with the subscription, which may still be filling it at the end
    std::unique_ptr<bus::Subscription> subscription;
  };
  void hear_sign(const bus::RawSample& sample);

  bus::Bus& bus_;
  Time began_;
  std::vector<Feed> feeds_;
  TopicLedger ledger_;
  bus::ServiceRoster roster_;
};

}  // namespace tandem::cli
