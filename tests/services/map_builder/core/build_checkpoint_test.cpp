#include "services/map_builder/core/build_checkpoint.hpp"

#include <gtest/gtest.h>

#include "services/map_builder/core/map_builder.hpp"
#include "services/map_builder/core/state_bytes.hpp"
#include "tests/services/map_builder/ring.hpp"

namespace tandem {
namespace {

class BuildCheckpoint : public testing::Test {
 protected:
  /// What a reading of `bytes` with `key` says against them; empty: nothing.
  [[nodiscard]] std::string refusal_of(const std::string& bytes, const BuildKey& key) const {
    const CheckpointReading reading = read_checkpoint(bytes, key, drive_, config_);
    EXPECT_EQ(reading.state.has_value(), reading.refusal.empty());
    return reading.refusal;
  }
  [[nodiscard]] std::string checkpoint_after(int pieces) const {
    MapBuild build{drive_, config_};
    for (int i = 0; i < pieces; ++i) build.advance();
    return checkpoint_of(build.state(), key_);
  }

  MapBuilderConfig config_;
  Drive drive_ = test::recorded(test::drive_around(5.0, 0.0), config_);
  BuildKey key_ = key_of(drive_, config_, "tandem 1.0");
};

TEST_F(BuildCheckpoint, HoldsAllOfAState) {
  const std::string bytes = checkpoint_after(25);  // 21 scans, then neighbours
  const CheckpointReading reading = read_checkpoint(bytes, key_, drive_, config_);
  ASSERT_TRUE(reading.state.has_value()) << reading.refusal;
  EXPECT_EQ(reading.state->stage, BuildStage::Neighbours);
  EXPECT_EQ(reading.state->graph.places.size(), 21U);
  EXPECT_FALSE(reading.state->refinement.pairs.empty());
  EXPECT_EQ(checkpoint_of(*reading.state, key_), bytes);
}

TEST_F(BuildCheckpoint, HoldsACorrectionThatWaitsToBeConfirmed) {
  BuildState state;
  state.closure_memory = {
      .looked_at_m = 4.0, .closed_at_m = 2.0, .unconfirmed_correction = Pose2{1.0, 2.0, 0.5}, .doubted = 3};
  const CheckpointReading reading = read_checkpoint(checkpoint_of(state, key_), key_, drive_, config_);
  ASSERT_TRUE(reading.state.has_value()) << reading.refusal;
  EXPECT_EQ(reading.state->closure_memory.unconfirmed_correction, (Pose2{1.0, 2.0, 0.5}));
  EXPECT_EQ(reading.state->closure_memory.doubted, 3U);
}

TEST_F(BuildCheckpoint, IsOfNoUseToAnotherRecordingConfigurationOrProgram) {
  const std::string bytes = checkpoint_after(10);
  EXPECT_EQ(refusal_of(bytes, key_), "");
  Drive longer = drive_;
  longer.scans.back().endpoints_in_base.back().x() += 1e-12;
  EXPECT_EQ(refusal_of(bytes, key_of(longer, config_, key_.program)), "is of another recording");
  MapBuilderConfig finer = config_;
  finer.resolution_m = 0.04;
  EXPECT_EQ(refusal_of(bytes, key_of(drive_, finer, key_.program)), "is of a build with other parameters");
  EXPECT_EQ(refusal_of(bytes, key_of(drive_, config_, "tandem 1.1")), "is of another version of the program");
}

TEST_F(BuildCheckpoint, IsRefusedWhereverItIsCutOffOrChanged) {
  const std::string bytes = checkpoint_after(10);
  for (std::size_t length = 0; length < bytes.size(); length += 7) {
    EXPECT_NE(refusal_of(bytes.substr(0, length), key_), "") << length;
  }
  for (std::size_t at = 0; at < bytes.size(); at += 13) {
    std::string changed = bytes;
    changed[at] ^= 0x10;
    EXPECT_NE(refusal_of(changed, key_), "") << at;
  }
  EXPECT_EQ(refusal_of(bytes + "x", key_), "is damaged");
  EXPECT_EQ(refusal_of("", key_), "is none that this version of the program can read");
}

TEST(NumberReader, GivesZeroWhereBytesAreMissing) {
  NumberWriter writer;
  writer.number(7);
  const std::string bytes = writer.take();
  NumberReader reader{bytes};
  int first = 0;
  double second = 1.0;
  reader.number(first);
  EXPECT_TRUE(reader.is_whole());
  reader.number(second);
  EXPECT_EQ(first, 7);
  EXPECT_EQ(second, 0.0);
  EXPECT_FALSE(reader.is_whole());
}

TEST(NumberReader, MakesNoVectorLargerThanItsBytes) {
  NumberWriter writer;
  writer.number(std::uint64_t{1} << 40);
  const std::string bytes = writer.take();
  NumberReader reader{bytes};
  std::vector<Pose2> poses;
  reader.size(poses);
  EXPECT_TRUE(poses.empty());
  EXPECT_FALSE(reader.is_whole());
}

}  // namespace
}  // namespace tandem
