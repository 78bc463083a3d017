#include "engine/tracking/ndi/ndi_hexadecimal.h"

#include <charconv>

namespace carina::ndi
{

std::string inHexadecimal(std::size_t number, std::size_t digits)
{
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string text(digits, '0');
    for (auto digit = text.rbegin(); digit != text.rend(); ++digit, number >>= 4U)
        *digit = kDigits[number & 0xFU];
    return text;
}

std::optional<std::uint16_t> fromHexadecimal(std::string_view digits)
{
    std::uint16_t number = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, fault] = std::from_chars(digits.data(), end, number, 16);
    return fault == std::errc{} && stop == end && !digits.empty() ? std::optional{number}
                                                                  : std::nullopt;
}

} // namespace carina::ndi
