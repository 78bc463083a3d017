#pragma once

namespace carina
{

/// How long a test waits for what is to come of itself, on a machine that does much else. One that
/// passes waits only until it has come.
inline constexpr int kPatience_ms = 60'000;

} // namespace carina
