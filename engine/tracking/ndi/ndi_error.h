#pragma once

#include <cstdint>
#include <string>

namespace carina
{

/// What a code of ERRORnn means, and what helps where a person can help; "error 26" for a code that
/// is not in NDI's list. The list: ndicapi.h of PlusToolkit/ndicapi, "Error Codes", which has 01 to
/// 42 but for those that are reserved, F1, and F4 to F6.
[[nodiscard]] std::string errorMeaning(std::uint8_t code);

} // namespace carina
