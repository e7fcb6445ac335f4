// A person presses and presses, while a relay or a whole host is killed and started anew. Every message is applied, and
// by nobody twice.
//
// A service's memory of what it applied is as old as the state that it applied it to: one that starts anew has neither,
// and a message that is still unanswered then is repeated to it. So "twice" is counted in one life of a service.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <optional>
#include <set>

#include "services/simulator/phone.hpp"
#include "tests/network/team_on_the_air.hpp"
#include "tests/support/domain_lease.hpp"

namespace tandem::test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

const Conditions kLossy{.loss = 0.2};
constexpr double kTurning_mps = 0.15;

/// The id in a line of a log.
std::string id_in(const std::string& line) {
  const auto begin = line.find(" id=") + 4;
  return line.substr(begin, line.find(' ', begin) - begin);
}

/// How often each message was applied in each life of a service, by its log.
std::vector<std::map<std::string, int>> applications(const std::filesystem::path& log) {
  std::vector<std::map<std::string, int>> lives;
  std::ifstream file{log};
  for (std::string line; std::getline(file, line);) {
    if (line.find(" ready: ") != std::string::npos) lives.emplace_back();
    if (line.find("message applied: ") != std::string::npos) ++lives.back()[id_in(line)];
  }
  return lives;
}

/// Messages that the gateway refused, by its log: a pose that waited too long for the connection.
std::set<std::string> refused_by_gateway(const std::filesystem::path& log) {
  std::set<std::string> ids;
  std::ifstream file{log};
  for (std::string line; std::getline(file, line);) {
    if (line.find("command refused: ") != std::string::npos) ids.insert(id_in(line));
  }
  return ids;
}

class ExactlyOnce : public ::testing::Test {
 protected:
  bool begins() {
    lab_.emplace(std::vector<std::string>{"robot1", "laptop1"});
    auto options = team_on(*lab_, "robot1", "laptop1");
    options.scenario = "brl";
    options.play = true;  // the phone is the test's
    options.robot_domain = domains_[0];
    options.laptop_domain = domains_[1];
    options.link_domain = domains_[2];
    team_.emplace(options);
    sent_.emplace(team_->laptop_bus().in_order(topic::kHumanMessage));
    receipts_.emplace(team_->laptop_bus().in_order(topic::kMessageReceipt));
    phone_ = simulator::make_phone(team_->folder().participant_link.string(), "person1");
    return team_->run_until(seconds{90}, [&] {
      return team_->wheel_speed_mps().value_or(0.0) > kTurning_mps && look_at_phone().connected;
    });
  }

  simulator::Simulation::PhoneView look_at_phone() {
    // Its connection is made in here, and stays on the cable that the robot's host has to the laptop.
    return lab_->host("robot1").run([&] { return phone_->view(clock_.now()); });
  }

  /// The person presses five times a second, what they are doing and what they want by turns.
  void press_for(Duration duration) {
    const Time end = clock_.now() + duration;
    Time next = clock_.now();
    std::ignore = team_->run_until(duration + seconds{10}, [&] {
      listen();
      if (clock_.now() >= next) {
        next += milliseconds{200};
        const bool pose = ++pressed_ % 2 == 0;
        phone_->press({.press = pose ? simulator::PhonePress::MyPose : simulator::PhonePress::MyGoal,
                       .point_in_map = Eigen::Vector2d{4.0, 12.0},
                       .heading = {}},
                      clock_.now());
      }
      return clock_.now() >= end;
    });
  }

  /// ... and afterwards some messages have not arrived, and some have, but not their receipts.
  void press_while_all_fails() {
    lab_->set_all(kLossy);
    press_for(seconds{2});
    lab_->set("robot1", {.out = true});
    press_for(seconds{1});
    lab_->set("robot1", kLossy);
    lab_->set("laptop1", {.out = true});
    press_for(seconds{1});
    lab_->set("laptop1", kLossy);
  }

  void kill_all(const std::string& host) {
    for (const auto& service : killed_ = team_->services(host)) team_->kill(host, service);
  }
  void start_all(const std::string& host) {
    for (const auto& service : killed_) team_->start_again(host, service);
  }

  void listen() {
    std::ignore = look_at_phone();
    for (const auto& message : sent_->take()) {
      ids_.insert(message.message.id());
      if (message.message.kind() == msg::HUMAN_MY_POSE) poses_.insert(message.message.id());
    }
    for (const auto& receipt : receipts_->take()) {
      if (receipt.message.topic() != topic::kHumanMessage.name) continue;
      answers_[receipt.message.id()].insert(receipt.message.by());
      if (!receipt.message.applied()) refused_.insert(receipt.message.id());
    }
  }

  /// Waits until each press became a message that planner and tracker answered, or that somebody refused.
  bool all_are_answered() {
    return team_->run_until(seconds{40}, [&] {
      listen();
      for (const auto& id : refused_by_gateway(team_->folder().logs / "laptop-of-robot1-gateway.log")) {
        ids_.insert(id);
        refused_.insert(id);
      }
      return ids_.size() == pressed_ && std::all_of(ids_.begin(), ids_.end(), [&](const std::string& id) {
               return refused_.contains(id) || answers_[id].size() == 2;
             });
    });
  }

  /// What is wrong with the answers, and the logs' last lines.
  std::string told() {
    std::string text = std::to_string(pressed_) + " presses, " + std::to_string(ids_.size()) + " messages\n";
    for (const auto& id : ids_) {
      if (refused_.contains(id) || answers_[id].size() == 2) continue;
      text += id + " answered by";
      for (const auto& service : answers_[id]) text += " " + service;
      text += "\n";
    }
    return text + team_->last_words();
  }

  /// The number of lives the service had. In none it applied a message twice; those that nobody refused it did apply.
  std::size_t expect_applied_once(const std::string& host, const std::string& service) {
    const auto lives = applications(team_->folder().logs / (host + "-" + service + ".log"));
    std::set<std::string> applied;
    for (const auto& life : lives) {
      for (const auto& [id, times] : life) {
        EXPECT_EQ(times, 1) << service << " " << id;
        applied.insert(id);
      }
    }
    EXPECT_FALSE(applied.empty()) << service;
    for (const auto& id : ids_) {
      const bool concerned = service == "planner" || poses_.contains(id);  // the tracker by poses alone
      EXPECT_TRUE(!concerned || applied.contains(id) || refused_.contains(id)) << service << " " << id;
    }
    return lives.size();
  }

  DomainLease domains_{3};
  SteadyClock clock_;
  std::optional<Laboratory> lab_;
  std::optional<SimulatedTeam> team_;
  std::unique_ptr<simulator::Phone> phone_;
  std::optional<bus::InOrder<msg::HumanMessage, msg::HumanMessagePubSubType>> sent_;
  std::optional<bus::InOrder<msg::MessageReceipt, msg::MessageReceiptPubSubType>> receipts_;
  std::size_t pressed_ = 0;
  std::set<std::string> ids_;
  std::set<std::string> poses_;  ///< of them
  std::set<std::string> refused_;
  std::map<std::string, std::set<std::string>> answers_;
  std::vector<std::string> killed_;
};

TEST_F(ExactlyOnce, ThroughARestartOfTheRelays) {
  TANDEM_NEEDS_LABORATORY();
  ASSERT_TRUE(begins()) << team_->last_words();
  lab_->set_all(kLossy);
  for (const char* host : {"robot1", "laptop-of-robot1"}) {
    press_for(seconds{2});
    team_->kill(host, "relay");
    press_for(seconds{1});
    team_->start_again(host, "relay");
    press_for(seconds{4});
    EXPECT_TRUE(all_are_answered()) << host << ": " << told();
  }
  EXPECT_EQ(expect_applied_once("laptop-of-robot1", "planner"), 1U);
  EXPECT_EQ(expect_applied_once("robot1", "tracker"), 1U);
}

TEST_F(ExactlyOnce, ThroughARestartOfTheLaptop) {
  TANDEM_NEEDS_LABORATORY();
  ASSERT_TRUE(begins()) << team_->last_words();
  press_while_all_fails();
  kill_all("laptop-of-robot1");
  start_all("laptop-of-robot1");
  press_for(seconds{8});
  EXPECT_TRUE(all_are_answered()) << told();
  EXPECT_EQ(expect_applied_once("laptop-of-robot1", "planner"), 2U);
  EXPECT_EQ(expect_applied_once("robot1", "tracker"), 1U);
}

TEST_F(ExactlyOnce, ThroughARestartOfTheRobot) {
  TANDEM_NEEDS_LABORATORY();
  ASSERT_TRUE(begins()) << team_->last_words();
  press_while_all_fails();
  kill_all("robot1");
  press_for(seconds{1});
  start_all("robot1");
  press_for(seconds{8});
  EXPECT_TRUE(all_are_answered()) << told();
  EXPECT_EQ(expect_applied_once("laptop-of-robot1", "planner"), 1U);
  EXPECT_EQ(expect_applied_once("robot1", "tracker"), 2U);
}

}  // namespace
}  // namespace tandem::test
