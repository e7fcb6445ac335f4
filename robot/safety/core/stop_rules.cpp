#include "robot/safety/core/stop_rules.hpp"

namespace tandem::safety {

Causes causes_with(Resume resume) {
  Causes causes;
  for (const StopRule& rule : kStopRules) causes.set(index_of(rule.cause), rule.resume == resume);
  return causes;
}

}  // namespace tandem::safety
