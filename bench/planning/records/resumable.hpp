#pragma once

#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

#include "bench/planning/records/json_lines.hpp"

namespace tandem::bench {

/// What a long run needs to know while it goes on.
struct RunControl {
  std::filesystem::path results_file;  ///< Appended to as soon as a record is there; empty: kept nowhere.
  int threads = 1;
  std::function<bool()> stop = [] { return false; };  ///< asked before each piece of work
};

/// Makes the records that the results file does not hold yet, and appends each as soon as it is there, so that a run
/// that was stopped goes on where it was left. `on_record` hears of each new one and how many are left. Gives all that
/// were asked for and are there, old and new, in the order of `requests`.
///
/// A request has a `key`, and so has a record; `make` turns one into the other and is called on several threads.
template <typename Record, typename Request, typename Make, typename OnRecord>
[[nodiscard]] std::vector<Record> resumed(const std::vector<Request>& requests, const Make& make,
                                          const OnRecord& on_record, const RunControl& control) {
  std::map<decltype(Record::key), Record> records;
  for (Record& record : read_lines<Record>(control.results_file)) records.insert_or_assign(record.key, record);
  std::vector<const Request*> missing;
  for (const Request& request : requests) {
    if (!records.contains(request.key)) missing.push_back(&request);
  }
  std::ofstream out;
  if (!missing.empty() && !control.results_file.empty()) {
    out.open(control.results_file, std::ios::app);
    if (!out) throw FileError(control.results_file.string() + ": cannot be written");
  }
  std::mutex mutex;
  std::size_t next = 0;
  std::size_t left = missing.size();
  std::exception_ptr failure;
  const auto work = [&] {
    while (true) {
      const Request* mine = nullptr;
      {
        const std::lock_guard lock(mutex);
        if (failure || next == missing.size() || control.stop()) return;
        mine = missing[next++];
      }
      try {
        const Record record = make(*mine);
        const std::lock_guard lock(mutex);
        if (out.is_open()) out << to_line(record) << '\n' << std::flush;
        records.insert_or_assign(record.key, record);
        on_record(record, --left);
      } catch (...) {
        const std::lock_guard lock(mutex);
        failure = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> workers;
    for (int i = 1; i < control.threads; ++i) workers.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
  std::vector<Record> all;
  for (const Request& request : requests) {
    if (const auto found = records.find(request.key); found != records.end()) all.push_back(found->second);
  }
  return all;
}

}  // namespace tandem::bench
