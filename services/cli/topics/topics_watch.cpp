#include "services/cli/topics/topics_watch.hpp"

#include <algorithm>

#include "services/bus/health.hpp"
#include "services/bus/peer_watch.hpp"
#include "services/common/version.hpp"

namespace tandem::cli {
namespace {

constexpr std::size_t kMostSamples = 10'000;  // between two steps

}  // namespace

TopicsWatch::TopicsWatch(bus::Bus& bus) : bus_(bus), began_(bus.clock().now()) {
  for (const TopicInfo& topic : all_topics()) {
    Feed feed{std::string{topic.name}, topic.delivery == Delivery::State || topic.delivery == Delivery::Bulk,
              std::make_shared<bus::InOrderBox>(kMostSamples), nullptr};
    feed.subscription = bus.subscribe(topic, feed.box);
    feeds_.push_back(std::move(feed));
  }
}

void TopicsWatch::step() {
  for (const Feed& feed : feeds_) {
    for (const auto& sample : feed.box->take()) {
      if (sample.sequence_number == 0) continue;  // nothing was sent: a writer vanished, or is back
      ledger_.heard({feed.topic, sample.writer, sample.sequence_number, sample.received, feed.latched});
      if (feed.topic == topic::kServiceHealth.name) hear_sign(sample);
    }
  }
}

void TopicsWatch::hear_sign(const bus::RawSample& sample) {
  if (sample.kind != bus::RawSample::Kind::Data) return;
  const auto health = bus::decode<msg::ServiceHealthPubSubType>(sample.payload);
  if (health) roster_.heard(bus::sign_of(*health), sample.received);
}

TopicsView TopicsWatch::view() {
  const Time now = bus_.clock().now();
  TopicsView view;
  view.watched_s = to_seconds(now - began_);
  std::vector<std::string> names;
  for (const Feed& feed : feeds_) names.push_back(feed.topic);
  view.topics = ledger_.view(names, bus_.peers().endpoints(), bus_.peers().malformed_counts(), now);
  view.services = roster_.alive(now);
  view.faults = bus_.peer_faults(bus::Concern::All);
  const auto append = [&](std::vector<bus::PeerFault> faults) {
    std::move(faults.begin(), faults.end(), std::back_inserter(view.faults));
  };
  append(roster_.doubles(now));
  append(roster_.other_contracts("", contract_hash(), now));
  std::sort(view.faults.begin(), view.faults.end());
  return view;
}

}  // namespace tandem::cli
