#pragma once

#include <string>

namespace tandem::cli {

/// The JSON schema of a message type of Foxglove ("foxglove.SceneUpdate"), as its viewers want it in a recording:
/// FrameTransform, Grid, PointCloud and SceneUpdate. See https://docs.foxglove.dev/docs/sdk/schemas.
[[nodiscard]] std::string foxglove_schema(const std::string& name);

}  // namespace tandem::cli
