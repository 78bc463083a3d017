#pragma once

#include "engine/sync/wire/stream_cpo.h"
#include "engine/tracking/pose_sample.h"

namespace carina
{

/// A sample X_A<object> as it is sent; object and sequence are the sender's to fill in.
[[nodiscard]] StreamCpo toStream(const PoseSample& sample);
[[nodiscard]] PoseSample fromStream(const StreamCpo& cpo);

} // namespace carina
