#include "bench/planning/records/resumable.hpp"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace tandem::bench {
namespace {

struct Request {
  int key = 0;
};

struct Record {
  int key = 0;
  double square = 0.0;

  template <typename Self, typename Visitor>
  static void visit_fields(Self& record, Visitor&& field) {
    field("key", record.key);
    field("square", record.square);
  }
};

Record squared(const Request& request) {
  return {request.key, static_cast<double>(request.key * request.key)};
}

class Resumable : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "records.jsonl";
  std::vector<Request> requests_{{1}, {2}, {3}};
  int made_ = 0;
};

TEST_F(Resumable, GoesOnWhereItWasLeftOff) {
  const auto count = [&](const Record&, std::size_t) { ++made_; };
  const auto first = resumed<Record>(requests_, squared, count, {file_, 1, [&] { return made_ == 2; }});
  EXPECT_EQ(first.size(), 2U);
  const auto all = resumed<Record>(requests_, squared, count, {file_, 1});
  EXPECT_EQ(made_, 3);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_DOUBLE_EQ(all[2].square, 9.0);
  EXPECT_EQ(read_lines<Record>(file_).size(), 3U);
}

TEST_F(Resumable, TwoThreadsMakeEachOnce) {
  std::size_t least_left = 3;
  const auto all =
      resumed<Record>(requests_, squared, [&](const Record&, std::size_t left) { least_left = left; }, {file_, 2});
  EXPECT_EQ(all.size(), 3U);
  EXPECT_EQ(least_left, 0U);
  EXPECT_EQ(read_lines<Record>(file_).size(), 3U);
}

TEST_F(Resumable, AFailureComesThrough) {
  const auto fail = [](const Request&) -> Record { throw ConfigError("no"); };
  EXPECT_THROW((void)resumed<Record>(requests_, fail, [](const Record&, std::size_t) {}, {file_, 2}), ConfigError);
}

}  // namespace
}  // namespace tandem::bench
