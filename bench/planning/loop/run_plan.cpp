#include "bench/planning/loop/run_plan.hpp"

#include <algorithm>
#include <charconv>

#include "services/common/config.hpp"
#include "services/planner/remote/named_planner.hpp"

namespace tandem::bench {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

template <typename Number>
Number parse_number(const std::string& text, const std::string& what) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) {
    throw ConfigError("'" + text + "' is no number: " + what);
  }
  return number;
}

}  // namespace

std::vector<RunRequest> all_runs(const std::vector<std::string>& families, const std::vector<std::uint64_t>& seeds,
                                 const std::vector<std::string>& planners, const std::vector<PlanningBudget>& budgets) {
  std::vector<RunRequest> runs;
  for (const auto& family : families) {
    for (const std::uint64_t seed : seeds) {
      for (const auto& budget : budgets) {
        for (const auto& planner : planners) runs.push_back({{family, seed, planner, budget_label(budget), 1}, budget});
      }
    }
  }
  return runs;
}

std::vector<std::uint64_t> parse_seeds(const std::string& text) {
  const std::string what = "seeds are written 3 or 1:6 or 1,4,7:9";
  std::vector<std::uint64_t> seeds;
  for (const std::string& part : split(text, ',')) {
    const auto ends = split(part, ':');
    if (ends.size() > 2) throw ConfigError("'" + part + "': " + what);
    const auto first = parse_number<std::uint64_t>(ends.front(), what);
    const auto last = parse_number<std::uint64_t>(ends.back(), what);
    for (std::uint64_t seed = first; seed <= last; ++seed) seeds.push_back(seed);
  }
  return seeds;
}

std::vector<PlanningBudget> parse_budgets(const std::string& text) {
  const std::string what = "budgets are written 50,200 (milliseconds) or 500r (rollouts)";
  std::vector<PlanningBudget> budgets;
  for (const std::string& part : split(text, ',')) {
    if (part.ends_with('r')) {
      budgets.push_back({0.0, parse_number<int>(part.substr(0, part.size() - 1), what)});
    } else {
      budgets.push_back({parse_number<double>(part, what), std::nullopt});
    }
  }
  return budgets;
}

RunRecord made_run(const RunRequest& request) {
  const PlanningInstance instance = instance_of(request.key.family, request.key.seed);
  // NAME@clairvoyant knows where the person will go, NAME@alone hears nothing of them (S5).
  const std::string planner = request.key.planner.substr(0, request.key.planner.find('@'));
  const std::string mode = request.key.planner.substr(std::min(planner.size() + 1, request.key.planner.size()));
  LoopOptions options;
  options.budget = request.budget;
  options.seed = request.key.planner_seed;
  options.shares_looks = !planner.starts_with("independent");
  const auto make = [&] { return named_planner(planner, 1e-3 * request.budget.cpu_ms); };
  if (!mode.empty()) {
    if (instance.human.empty())
      throw ConfigError(request.key.planner + " needs a family with a person of its own will");
    const LoopResult as_usual = played(instance, make, options);
    options.person_path = as_usual.walked[person_of(instance)].path;
    options.person = mode == "clairvoyant" ? PersonIs::Known : PersonIs::Ignored;
  }
  return record_of(request.key, instance, played(instance, make, options));
}

}  // namespace tandem::bench
