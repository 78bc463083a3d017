#pragma once

/// With what carina-surface-reader ends where it has no answer.
namespace carina::reader_exit
{

inline constexpr int kWrongArguments = 2;
inline constexpr int kNotConfined = 3;
inline constexpr int kOutOfMemory = 4;

} // namespace carina::reader_exit
