#include <algorithm>
#include <map>

#include "bench/network/airs.hpp"
#include "bench/network/measurements.hpp"
#include "bench/network/quantiles.hpp"
#include "bench/network/stream.hpp"
#include "services/bus/event_log.hpp"

namespace tandem::bench {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr int kMessages = 60;
constexpr Duration kPeriod = milliseconds{150};
constexpr Duration kPatience = seconds{20};

/// The robot: applies each message once, answers each that comes.
class Applier {
 public:
  Applier(Side& robot, bool tells_repetitions)
      : tells_repetitions_(tells_repetitions),
        in_(robot, info_of(topic::kPoseHint)),
        out_(robot.writer(info_of(topic::kMessageReceipt))) {}

  void step() {
    for (const auto& sample : in_.arrivals->take()) {
      const auto hint = bus::decode<msg::PoseHintPubSubType>(sample.payload);
      if (!hint) continue;
      if (!tells_repetitions_ || log_.is_new(hint->id())) ++applied_[hint->id()];
      msg::MessageReceipt receipt;
      receipt.id(hint->id());
      receipt.by("localization");
      receipt.applied(true);
      out_->write(bus::encode<msg::MessageReceiptPubSubType>(receipt), {});
    }
  }
  [[nodiscard]] int applied_twice() const {
    return static_cast<int>(
        std::count_if(applied_.begin(), applied_.end(), [](const auto& one) { return one.second > 1; }));
  }
  [[nodiscard]] std::size_t applied() const { return applied_.size(); }
  void begin_count() { applied_.clear(); }
  [[nodiscard]] int writers() const { return in_.subscription->matched_writers(); }

 private:
  bool tells_repetitions_;
  Listener in_;
  std::unique_ptr<bus::RawWriter> out_;
  bus::AppliedEvents log_;
  std::map<std::string, int> applied_;
};

/// The laptop: sends, ours repeats until the receipt is there.
class Sender {
 public:
  Sender(Side& laptop, bool repeats)
      : repeats_(repeats),
        out_(laptop.writer(info_of(topic::kPoseHint))),
        in_(laptop, info_of(topic::kMessageReceipt)),
        events_({"localization"}, seconds{1}, seconds{600}) {}

  void send(int number) {
    msg::PoseHint hint;
    hint.robot("robot1");
    hint.id("message " + std::to_string(number));
    hint.who(std::string(100, 'x'));
    sent_[hint.id()] = {hint, clock_.now()};
    events_.sent(hint.id(), clock_.now());
    write(hint);
  }
  void step() {
    for (const auto& sample : in_.arrivals->take()) {
      const auto receipt = bus::decode<msg::MessageReceiptPubSubType>(sample.payload);
      if (!receipt || !events_.is_pending(receipt->id())) continue;
      events_.answered(receipt->id(), receipt->by(), true, "");
      round_trips_ms_.push_back(to_ms(sample.received - sent_.at(receipt->id()).second));
    }
    for (const auto& id : events_.due(clock_.now())) {
      if (repeats_) write(sent_.at(id).first);
    }
  }
  [[nodiscard]] const std::vector<double>& round_trips_ms() const { return round_trips_ms_; }
  [[nodiscard]] bool knows_both_ways() const {
    return out_->matched_readers() > 0 && in_.subscription->matched_writers() > 0;
  }

 private:
  void write(const msg::PoseHint& hint) {
    out_->write(bus::encode<msg::PoseHintPubSubType>(hint), bus::key_of<msg::PoseHintPubSubType>(hint));
  }
  SteadyClock clock_;
  bool repeats_;
  std::unique_ptr<bus::RawWriter> out_;
  Listener in_;
  bus::SentEvents events_;
  std::map<std::string, std::pair<msg::PoseHint, Time>> sent_;
  std::vector<double> round_trips_ms_;
};

}  // namespace

Figures messages(const std::string& whose, const std::string& air, int run) {
  test::Laboratory lab{{"robot", "laptop"}, seed_of(run)};
  const auto robot = make_side(whose, lab.host("robot"), lab.host("laptop").address());
  const auto laptop = make_side(whose, lab.host("laptop"), lab.host("robot").address());
  const bool ours = whose == "ours";
  Applier applier{*robot, ours};
  Sender sender{*laptop, ours};
  const auto step = [&] {
    applier.step();
    sender.step();
    return false;
  };
  // Matched on a clean air, through relays and all, before the loss begins.
  sender.send(-1);
  holds_within(seconds{30}, [&] {
    step();
    if (!ours && sender.round_trips_ms().empty() && sender.knows_both_ways() && applier.writers() > 0) sender.send(-1);
    return !sender.round_trips_ms().empty();
  });
  pause(seconds{1});
  step();
  const std::size_t first = sender.round_trips_ms().size();
  applier.begin_count();
  lab.set_all(conditions_of(air));
  for (int i = 0; i < kMessages; ++i) {
    sender.send(i);
    holds_within(kPeriod, step);
  }
  holds_within(kPatience, [&] {
    step();
    return sender.round_trips_ms().size() == first + kMessages;
  });
  const std::vector<double> times{sender.round_trips_ms().begin() + static_cast<std::ptrdiff_t>(first),
                                  sender.round_trips_ms().end()};
  return {{"p50_ms", observed_quantile(times, 0.5, kNever)},
          {"p99_ms", observed_quantile(times, 0.99, kNever)},
          {"max_ms", observed_quantile(times, 1.0, kNever)},
          {"unanswered", static_cast<double>(kMessages) - static_cast<double>(times.size())},
          {"lost", static_cast<double>(kMessages) - static_cast<double>(applier.applied())},
          {"applied_twice", applier.applied_twice()}};
}

}  // namespace tandem::bench
