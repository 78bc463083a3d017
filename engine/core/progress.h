#pragma once

#include <functional>

namespace carina
{

/// Called with the share of a long work that is done, 0 to 1; returns false to stop it. Called in
/// the thread that does the work.
using Progress = std::function<bool(double share)>;

} // namespace carina
