#pragma once

namespace carina::detail
{

/// Prints the broken condition with its place and aborts.
[[noreturn]] void expectationFailed(const char* condition, const char* file, int line);

} // namespace carina::detail

/// Holds a programmer to a contract. Always on: a broken contract stops the program at once instead
/// of drawing an airway in the wrong place.
#define CARINA_EXPECTS(condition)                                                                  \
    ((condition) ? static_cast<void>(0)                                                            \
                 : ::carina::detail::expectationFailed(#condition, __FILE__, __LINE__))
