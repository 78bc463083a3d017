#pragma once

#include "engine/sync/wire/stream_cpo.h"
#include "engine/tracking/pose_sample.h"

namespace carina
{

/// A sample X_A<object> in the form in which it is sent; the caller sets object and sequence.
[[nodiscard]] StreamCpo toStream(const PoseSample& sample);
[[nodiscard]] PoseSample fromStream(const StreamCpo& cpo);

} // namespace carina
