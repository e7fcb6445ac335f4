#pragma once

#include <functional>

namespace tandem::bench {

/// The processor time that this thread has used [ms]: budgets do not depend on what else the machine does.
[[nodiscard]] double thread_cpu_ms();

/// Says true once this thread has used `budget_ms` more processor time than now.
[[nodiscard]] std::function<bool()> stop_after_cpu_ms(double budget_ms);

}  // namespace tandem::bench
