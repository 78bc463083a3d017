#include "engine/tracking/ndi/recorded_line.h"

#include "engine/tracking/sequence_fields.h"

#include <algorithm>

namespace carina::ndi
{
namespace
{

constexpr std::string_view kCommand = "command[";
constexpr std::string_view kReceive = "receive[";

bool isDigit(char c) { return c >= '0' && c <= '9'; }

int hexadecimalDigit(char c)
{
    if (isDigit(c))
        return c - '0';
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

} // namespace

std::optional<std::size_t> takeNumber(std::string_view& text)
{
    const auto end = std::ranges::find_if_not(text, isDigit);
    const auto digits = text.substr(0, std::size_t(end - text.begin()));
    const auto number = field::numberOf<std::size_t>(digits);
    if (number)
        text.remove_prefix(digits.size());
    return number;
}

bool skip(std::string_view& text, std::string_view word)
{
    if (!text.starts_with(word))
        return false;
    text.remove_prefix(word.size());
    return true;
}

std::optional<EntryHead> takeHead(std::string_view& text)
{
    std::string_view rest = text;
    const auto number = takeNumber(rest);
    if (!number || !skip(rest, ". "))
        return std::nullopt;
    const bool isReply = skip(rest, kReceive);
    if (!isReply && !skip(rest, kCommand))
        return std::nullopt;
    const auto bytes = takeNumber(rest);
    if (!bytes || !skip(rest, "] "))
        return std::nullopt;
    text = rest;
    return EntryHead{*number, isReply, *bytes};
}

std::optional<std::string> unescaped(std::string_view text)
{
    std::string bytes;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\\') {
            bytes += text[i];
            continue;
        }
        const std::string_view code = text.substr(i + 1, 3);
        if (code.starts_with('\\')) {
            bytes += '\\';
            ++i;
        } else if (code.size() == 3 && code[0] == 'x' && hexadecimalDigit(code[1]) >= 0
                   && hexadecimalDigit(code[2]) >= 0) {
            bytes += static_cast<char>(16 * hexadecimalDigit(code[1]) + hexadecimalDigit(code[2]));
            i += code.size();
        } else {
            return std::nullopt;
        }
    }
    return bytes;
}

} // namespace carina::ndi
