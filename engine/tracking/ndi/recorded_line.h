#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// Parts of a line in a recorded conversation.
namespace carina::ndi
{

/// The beginning of an entry "41. receive[25] ".
struct EntryHead {
    std::size_t number = 0;
    bool isReply = false;
    std::size_t bytes = 0;
};

/// The number that a text begins with, which is taken from it.
[[nodiscard]] std::optional<std::size_t> takeNumber(std::string_view& text);

/// Takes a word from the beginning of a text; false where it is not there.
bool skip(std::string_view& text, std::string_view word);

/// Takes the beginning of an entry; nothing, and nothing is taken, where it is none.
[[nodiscard]] std::optional<EntryHead> takeHead(std::string_view& text);

/// The bytes that a text stands for in which those that do not print are \xHH.
[[nodiscard]] std::optional<std::string> unescaped(std::string_view text);

} // namespace carina::ndi
