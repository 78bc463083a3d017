#pragma once

namespace carina::detail
{

/// Prints the condition that does not hold with its file and line, and aborts.
[[noreturn]] void expectationFailed(const char* condition, const char* file, int line);

} // namespace carina::detail

/// Checks a precondition or an invariant, and aborts the program where it does not hold. Active in
/// release builds too: the program stops at once instead of drawing an airway in the wrong place.
#define CARINA_EXPECTS(condition)                                                                  \
    ((condition) ? static_cast<void>(0)                                                            \
                 : ::carina::detail::expectationFailed(#condition, __FILE__, __LINE__))
