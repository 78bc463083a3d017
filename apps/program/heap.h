#pragma once

#include "engine/core/session_time.h"

namespace carina::program
{

/// For how long a program keeps pages of its heap that hold no block.
inline constexpr Duration kFreePagesKept = std::chrono::seconds{2};

/// Lets the heap, which is jemalloc's, give pages that hold no block back to the system once they
/// have been free for a time. By default that is ten seconds.
///
/// Blocks of all sizes come and go with each frame, fact and patient, and what lives on lies
/// between them. jemalloc keeps blocks of about one size together, so that the holes are found
/// again; with glibc's heap a program grew without holding more.
void keepFreePagesFor(Duration time);

} // namespace carina::program
