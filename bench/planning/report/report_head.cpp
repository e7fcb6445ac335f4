#include "bench/planning/report/report_head.hpp"

#include "bench/planning/report/run_info.hpp"
#include "services/common/clock.hpp"
#include "services/common/version.hpp"

namespace tandem::bench {

ReportHead report_head(const std::string& command) {
  return {date_of(SteadyClock{}.now()), commit(), machine(), command};
}

}  // namespace tandem::bench
