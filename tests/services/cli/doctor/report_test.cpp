#include "services/cli/doctor/report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tandem::cli {
namespace {

const std::vector<Finding> kFindings{fine("system", "debian 12"), not_applicable("clock", "simulated"),
                                     warning("battery", "11.7 V", "above 11.8 V", "charge it"),
                                     fault("laser", "no scan", "scans", "plug it in")};

TEST(DoctorReport, SaysFoundWantedAndWhatToDo) {
  EXPECT_EQ(text_of(kFindings),
            "ok       system                   debian 12\n"
            "n/a      clock                    simulated\n"
            "warning  battery                  11.7 V\n"
            "                                  wanted: above 11.8 V\n"
            "                                  to do:  charge it\n"
            "error    laser                    no scan\n"
            "                                  wanted: scans\n"
            "                                  to do:  plug it in\n"
            "4 lines: 1 errors, 1 warnings\n");
}

TEST(DoctorReport, IsAsBadAsItsWorstLine) {
  EXPECT_EQ(worst_of(kFindings), Verdict::Error);
  EXPECT_EQ(worst_of({kFindings[0], kFindings[2]}), Verdict::Warning);
  EXPECT_EQ(worst_of({kFindings[0], kFindings[1]}), Verdict::Ok);
}

TEST(DoctorReport, IsForProgramsToo) {
  const auto json = nlohmann::json::parse(json_of(kFindings));
  EXPECT_EQ(json["verdict"], "error");
  EXPECT_EQ(json["lines"].size(), 4u);
  EXPECT_EQ(json["lines"][3]["fix"], "plug it in");
}

}  // namespace
}  // namespace tandem::cli
