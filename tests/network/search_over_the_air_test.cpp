// Whole searches, robot and laptop on hosts of their own, over an air that loses a fifth of all frames each way and
// dies for 0.3 s of each second.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/network/team_on_the_air.hpp"
#include "tests/support/domain_lease.hpp"

namespace tandem::test {
namespace {

using cli::Episode;
using std::chrono::milliseconds;
using std::chrono::seconds;

const Conditions kBadAir{.loss = 0.2, .dead_for = milliseconds{300}, .dead_every = seconds{1}};

/// What both hosts of a team hear of what must cross the link whole.
class Witness {
 public:
  explicit Witness(SimulatedTeam& team)
      : false_stops_(team),
        sent_(team.laptop_bus().in_order(topic::kHumanMessage)),
        receipts_(team.laptop_bus().in_order(topic::kMessageReceipt)),
        arrived_(team.robot_bus().in_order(topic::kHumanMessage)),
        laptop_plan_(team.laptop_bus().latest(topic::kTeamPlan)),
        robot_plan_(team.robot_bus().latest(topic::kTeamPlan)),
        laptop_map_(team.laptop_bus().latest(topic::kMap)),
        robot_map_(team.robot_bus().latest(topic::kMap)) {}

  void listen() {
    false_stops_.listen();
    for (const auto& message : sent_.take()) sent_ids_.insert(message.message.id());
    for (const auto& message : arrived_.take()) arrived_ids_.insert(message.message.id());
    for (const auto& receipt : receipts_.take()) {
      if (receipt.message.topic() != topic::kHumanMessage.name) continue;
      (receipt.message.applied() ? appliers_ : refusers_)[receipt.message.id()].insert(receipt.message.by());
    }
  }
  [[nodiscard]] const FalseStops& false_stops() const { return false_stops_; }
  [[nodiscard]] std::size_t messages() const { return sent_ids_.size(); }
  /// Has every message of the person been applied by all that should, wherever they are, or been refused by one?
  /// Whoever sent a message that was refused does not repeat it.
  [[nodiscard]] bool all_answered() const {
    const std::set<std::string> all{"planner", "tracker"};
    return std::all_of(sent_ids_.begin(), sent_ids_.end(), [&](const std::string& id) {
      const auto found = appliers_.find(id);
      return refusers_.contains(id) || (found != appliers_.end() && found->second == all && arrived_ids_.contains(id));
    });
  }
  /// Each message, whether it arrived, and who applied or refused it.
  [[nodiscard]] std::string told() const {
    std::string text;
    for (const std::string& id : sent_ids_) {
      text += id + (arrived_ids_.contains(id) ? " arrived" : " did not arrive");
      for (const auto& [verb, who] : {std::pair{" applied by ", &appliers_}, std::pair{" refused by ", &refusers_}}) {
        if (const auto found = who->find(id); found != who->end()) {
          for (const std::string& service : found->second) text += verb + service;
        }
      }
      text += "\n";
    }
    return text;
  }
  [[nodiscard]] bool same_plan() const {
    const auto laptop = laptop_plan_.newest();
    const auto robot = robot_plan_.newest();
    return laptop && robot && laptop->message.id() == robot->message.id() &&
           laptop->message.paths() == robot->message.paths();
  }
  [[nodiscard]] bool same_map() const {
    const auto laptop = laptop_map_.newest();
    const auto robot = robot_map_.newest();
    return laptop && robot && laptop->message == robot->message;
  }

 private:
  FalseStops false_stops_;
  bus::InOrder<msg::HumanMessage, msg::HumanMessagePubSubType> sent_;
  bus::InOrder<msg::MessageReceipt, msg::MessageReceiptPubSubType> receipts_;
  bus::InOrder<msg::HumanMessage, msg::HumanMessagePubSubType> arrived_;
  bus::Latest<msg::TeamPlan, msg::TeamPlanPubSubType> laptop_plan_;
  bus::Latest<msg::TeamPlan, msg::TeamPlanPubSubType> robot_plan_;
  bus::Latest<msg::OccupancyGrid, msg::OccupancyGridPubSubType> laptop_map_;
  bus::Latest<msg::OccupancyGrid, msg::OccupancyGridPubSubType> robot_map_;
  std::set<std::string> sent_ids_;
  std::set<std::string> arrived_ids_;
  std::map<std::string, std::set<std::string>> appliers_;
  std::map<std::string, std::set<std::string>> refusers_;
};

/// The search is over, what the person said has been heard everywhere, and both hosts have the same plan: at this
/// moment, for the next plan is on its way.
bool is_settled(SimulatedTeam& team, Witness& witness) {
  witness.listen();
  return team.episode().is_over() && witness.all_answered() && witness.same_plan();
}

void expect_good_end(SimulatedTeam& team, const Witness& witness) {
  EXPECT_EQ(team.episode().phase(), Episode::Phase::Found) << team.last_words();
  EXPECT_EQ(witness.false_stops().of_base(), std::vector<msg::StopReason>{}) << team.last_words();
  EXPECT_EQ(witness.false_stops().for_want_of_a_plan(), 0) << team.last_words();
  EXPECT_GT(witness.messages(), 0U);
  EXPECT_TRUE(witness.all_answered()) << witness.told();
  EXPECT_TRUE(witness.same_map());
}

TEST(SearchOverTheAir, EndsWithTheObjectFoundAtTwentyPercentLossWithBursts) {
  TANDEM_NEEDS_LABORATORY();
  const DomainLease domains{3};
  Laboratory lab{{"robot1", "laptop1"}};
  lab.set_all(kBadAir);
  TeamOptions options = team_on(lab, "robot1", "laptop1");
  options.robot_domain = domains[0];
  options.laptop_domain = domains[1];
  options.link_domain = domains[2];
  SimulatedTeam team{options};
  Witness witness{team};

  EXPECT_TRUE(team.run_until(seconds{100}, [&] { return is_settled(team, witness); })) << team.last_words();

  expect_good_end(team, witness);
}

TEST(SearchOverTheAir, EndsSoForTwoTeamsOnOneAir) {
  TANDEM_NEEDS_LABORATORY();
  const DomainLease domains{5};
  Laboratory lab{{"robot1", "laptop1", "robot2", "laptop2"}};
  lab.set_all(kBadAir);
  TeamOptions first = team_on(lab, "robot1", "laptop1");
  first.robot_domain = domains[0];
  first.laptop_domain = domains[1];
  first.link_domain = domains[4];
  TeamOptions second = team_on(lab, "robot2", "laptop2");
  second.agent = "person2";
  second.seed = 2;
  second.robot_domain = domains[2];
  second.laptop_domain = domains[3];
  second.link_domain = domains[4];
  SimulatedTeam team1{first};
  SimulatedTeam team2{second};
  Witness witness1{team1};
  Witness witness2{team2};

  bool second_runs = true;
  const auto both_are_settled = [&] {
    second_runs = team2.run_until(seconds{1}, [] { return true; });
    const bool second_is_settled = is_settled(team2, witness2);
    return !second_runs || (is_settled(team1, witness1) && second_is_settled);
  };
  EXPECT_TRUE(team1.run_until(seconds{120}, both_are_settled)) << team1.last_words() << team2.last_words();

  EXPECT_TRUE(second_runs) << team2.last_words();
  expect_good_end(team1, witness1);
  expect_good_end(team2, witness2);
}

}  // namespace
}  // namespace tandem::test
