#pragma once

#include "models/tracker/pose_recording.h"

namespace carina
{

/// Ends a recording at the end of a program. While it is written in the form that was asked for, a
/// window tells how far it is, and lets that be cancelled: Carina's own record is kept. So it tells
/// what kept it from being written.
void finishRecording(PoseRecording& recording);

} // namespace carina
