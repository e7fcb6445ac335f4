#pragma once

#include <deque>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "services/bus/core/endpoint_table.hpp"
#include "services/cli/topics/topics_view.hpp"

namespace tandem::cli {

/// A sample as the ledger counts it.
struct HeardSample {
  std::string topic;
  bus::EndpointId writer{};
  std::uint64_t sequence_number = 0;
  Time received{};
  bool latched = false;  ///< of a State: the first ones are its past, with gaps where it was overwritten
};

/// Counts what each writer sends: rate, age, and the sequence numbers that never came.
class TopicLedger {
 public:
  void heard(const HeardSample& sample);
  /// Who is on `topics` (names, in the order to be shown) and on any other topic, and how they do.
  [[nodiscard]] std::vector<TopicView> view(const std::vector<std::string>& topics,
                                            const std::vector<bus::Endpoint>& endpoints,
                                            const std::vector<bus::MalformedCount>& malformed, Time now);

 private:
  struct Account {
    std::string participant;  ///< as last known
    std::deque<Time> recent;  ///< of the samples within the window of the rate
    Time first{};             ///< when it was first heard
    Time last{};
    std::uint64_t samples = 0;
    std::uint64_t counted = 0;  ///< of them, since `base`
    std::uint64_t base = 0;     ///< the sequence number before the first that counts
    std::uint64_t highest = 0;  ///< sequence number heard
  };
  using Key = std::pair<std::string, bus::EndpointId>;

  [[nodiscard]] WriterView writer_view(const Account& account, std::uint64_t malformed, Time now) const;

  std::map<Key, Account> accounts_;
};

}  // namespace tandem::cli
