#include "services/bus/events.hpp"

#include <gtest/gtest.h>

#include "tests/support/domain_lease.hpp"

namespace tandem::bus {
namespace {

using std::chrono::seconds;

DomainOptions options_in(int domain, const std::string& name) {
  DomainOptions options;
  options.domain = domain;
  options.participant = name;
  return options;
}

TEST(Events, AnEventSentBeforeItsReaderExistsIsAppliedOnceAndReceipted) {
  const test::DomainLease domain{1};
  Bus phone{options_in(domain[0], "phone")};
  EventSender stops{phone, topic::kStopRequest};
  msg::StopRequest stop;
  stop.id(new_event_id("phone", phone.clock()));
  stops.send(stop);
  EXPECT_EQ(stops.outcome(stop.id()).state, EventOutcome::State::Pending);

  Bus robot{options_in(domain[0], "robot")};
  EventReceiver requests{robot, topic::kStopRequest, "base"};
  int applied = 0;
  EXPECT_TRUE(wait_until(robot, seconds{20}, [&] {
    for (const auto& event : requests.take()) {
      ++applied;
      requests.applied(event.id());
    }
    stops.step();
    return stops.outcome(stop.id()).state == EventOutcome::State::Applied;
  }));
  EXPECT_EQ(applied, 1);
}

TEST(Events, IdsOfOneProcessAllDiffer) {
  const ManualClock clock;
  EXPECT_NE(new_event_id("a", clock), new_event_id("a", clock));
}

TEST(Events, AppliersAreSplitAtCommas) {
  EXPECT_EQ(split_appliers("planner,tracker"), (std::vector<std::string>{"planner", "tracker"}));
  EXPECT_TRUE(split_appliers("").empty());
}

}  // namespace
}  // namespace tandem::bus
