#pragma once

#include <memory>
#include <string>
#include <vector>

#include "services/bus/bus.hpp"
#include "tests/network/relayed_host.hpp"

namespace tandem::bench {

/// One end of the link, as a program of that host sees it.
class Side {
 public:
  virtual ~Side() = default;
  [[nodiscard]] virtual std::unique_ptr<bus::RawWriter> writer(const TopicInfo& topic) = 0;
  [[nodiscard]] virtual std::unique_ptr<bus::Subscription> subscribe(const TopicInfo& topic,
                                                                     std::shared_ptr<bus::Mailbox> mailbox) = 0;
  /// CPU time of the processes between the program and the air [s]; 0 where there are none.
  [[nodiscard]] virtual double cpu_s() const { return 0.0; }
};

/// "ours": a host with its relay as a process; "secured": the same on a secured link. "default": a participant on the
/// link with Fast DDS's defaults, over UDP alone (shared memory would bypass the air). The host "robot" is the robot's.
[[nodiscard]] std::unique_ptr<Side> make_side(const std::string& whose, test::LabHost& host,
                                              const std::string& peer_address);

/// As make_side, but ours without relay: a participant on the link with our QoS.
[[nodiscard]] std::unique_ptr<Side> make_link_side(const std::string& whose, test::LabHost& host,
                                                   const std::string& peer_address);

/// A mailbox that keeps every sample with its time of arrival.
class Arrivals final : public bus::Mailbox {
 public:
  void put(bus::RawSample sample) override;
  [[nodiscard]] std::vector<bus::RawSample> take();

 private:
  std::mutex mutex_;
  std::vector<bus::RawSample> samples_;
};

/// A reader with its mailbox.
struct Listener {
  std::shared_ptr<Arrivals> arrivals;
  std::unique_ptr<bus::Subscription> subscription;
  Listener(Side& side, const TopicInfo& topic)
      : arrivals(std::make_shared<Arrivals>()), subscription(side.subscribe(topic, arrivals)) {}
};

}  // namespace tandem::bench
