#include "services/cli/topics/topic_ledger.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace tandem::cli {
namespace {

constexpr Duration kRateWindow = std::chrono::seconds{5};
constexpr Duration kPastArrives = std::chrono::seconds{1};   // what a State had said before we came
constexpr Duration kGoneIsShown = std::chrono::seconds{30};  // a writer that vanished

/// "planner@laptop1" -> planner, laptop1. Names of strangers may be anything.
ReaderView split(const std::string& participant) {
  const auto at = participant.rfind('@');
  if (at == std::string::npos) return {"?", participant};
  return {participant.substr(at + 1), participant.substr(0, at)};
}

template <class View>
void sort_by_name(std::vector<View>& views) {
  std::sort(views.begin(), views.end(),
            [](const View& a, const View& b) { return std::tie(a.host, a.service) < std::tie(b.host, b.service); });
}

}  // namespace

void TopicLedger::heard(const HeardSample& sample) {
  Account& account = accounts_[{sample.topic, sample.writer}];
  if (account.samples == 0) {
    account.first = sample.received;
    account.base = sample.sequence_number - 1;
  }
  account.last = sample.received;
  account.recent.push_back(sample.received);
  ++account.samples;
  if (sample.latched && sample.received - account.first < kPastArrives) {
    account.base = std::max(account.base, sample.sequence_number);
  } else if (sample.sequence_number > account.base) {
    ++account.counted;
  }
  account.highest = std::max(account.highest, sample.sequence_number);
  while (account.recent.front() + kRateWindow < sample.received) account.recent.pop_front();
}

WriterView TopicLedger::writer_view(const Account& account, std::uint64_t malformed, Time now) const {
  WriterView view;
  view.samples = account.samples;
  view.malformed = malformed;
  if (account.samples == 0) return view;
  view.age_s = to_seconds(now - account.last);
  const auto recent = std::count_if(account.recent.begin(), account.recent.end(),
                                    [&](Time received) { return now - received <= kRateWindow; });
  // A writer that was just met has not had the whole window.
  const double window_s = std::clamp(to_seconds(now - account.first), 1.0, to_seconds(kRateWindow));
  view.rate_hz = static_cast<double>(recent) / window_s;
  const std::uint64_t sent = account.highest > account.base ? account.highest - account.base : 0;
  const std::uint64_t arrived = account.counted + malformed;
  view.lost = sent > arrived ? sent - arrived : 0;
  return view;
}

std::vector<TopicView> TopicLedger::view(const std::vector<std::string>& topics,
                                         const std::vector<bus::Endpoint>& endpoints,
                                         const std::vector<bus::MalformedCount>& malformed, Time now) {
  std::map<Key, std::uint64_t> bad;
  for (const auto& one : malformed) bad[{one.topic, one.writer}] += one.count;
  std::map<std::string, TopicView> views;
  std::set<Key> alive;
  for (const auto& endpoint : endpoints) {
    if (endpoint.own) continue;
    TopicView& view = views[endpoint.topic];
    const auto who = split(endpoint.participant);
    if (endpoint.kind == bus::Endpoint::Kind::Reader) {
      view.readers.push_back(who);
      continue;
    }
    const Key key{endpoint.topic, endpoint.id};
    alive.insert(key);
    accounts_[key].participant = endpoint.participant;
  }
  std::erase_if(accounts_, [&](const auto& item) {
    const bool is_shown = item.second.samples > 0 && now - item.second.last <= kGoneIsShown;
    return !alive.contains(item.first) && !is_shown;
  });
  for (const auto& [key, account] : accounts_) {
    if (account.participant.empty()) continue;  // our own, or one that left before we saw whose it was
    WriterView writer = writer_view(account, bad[key], now);
    const auto who = split(account.participant);
    writer.host = who.host;
    writer.service = who.service;
    writer.alive = alive.contains(key);
    views[key.first].writers.push_back(std::move(writer));
  }

  std::vector<TopicView> ordered;
  const auto append = [&](const std::string& name) {
    TopicView& view = views[name];
    view.topic = name;
    sort_by_name(view.writers);
    sort_by_name(view.readers);
    // A service may read a topic more than once: it is one that hears.
    const auto same = [](const ReaderView& a, const ReaderView& b) {
      return a.host == b.host && a.service == b.service;
    };
    view.readers.erase(std::unique(view.readers.begin(), view.readers.end(), same), view.readers.end());
    ordered.push_back(std::move(view));
    views.erase(name);
  };
  for (const auto& name : topics) append(name);
  while (!views.empty()) append(std::string{views.begin()->first});
  return ordered;
}

}  // namespace tandem::cli
