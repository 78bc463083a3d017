#include "engine/io/mesh/surface_text.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace carina
{
namespace
{

constexpr std::string_view kBlank = " \t\r";
constexpr int kCommentLinesRead = 64;
constexpr std::size_t kMostConceptDigits = 9;

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// What stands after "key :" where the comment begins so.
std::optional<std::string> valueOf(std::string_view key, std::string_view comment)
{
    if (!comment.starts_with(key))
        return std::nullopt;
    comment = trimmed(comment.substr(key.size()));
    if (!comment.starts_with(':'))
        return std::nullopt;
    return std::string{trimmed(comment.substr(1))};
}

std::optional<std::string_view> commentIn(std::string_view line)
{
    for (const std::string_view mark : {"#", "comment "})
        if (line.starts_with(mark))
            return trimmed(line.substr(mark.size()));
    return std::nullopt;
}

} // namespace

std::string_view takeLine(std::string_view& text)
{
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

std::string_view takeWord(std::string_view& line)
{
    line.remove_prefix(std::min(line.find_first_not_of(kBlank), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(kBlank));
    line.remove_prefix(word.size());
    return word;
}

bool isAttribution(std::string_view line)
{
    std::string lower{line};
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    constexpr std::array<std::string_view, 5> kWords{"license", "licence", "copyright", "(c)",
                                                     "cc by"};
    return std::any_of(kWords.begin(), kWords.end(), [&](std::string_view word) {
        return lower.find(word) != std::string::npos;
    });
}

std::optional<std::string> conceptIn(std::string_view text)
{
    constexpr std::string_view kPrefix = "FMA";
    for (std::size_t at = text.find(kPrefix); at != std::string_view::npos;
         at = text.find(kPrefix, at + 1)) {
        const std::size_t first = at + kPrefix.size();
        const std::size_t end = std::min(text.find_first_not_of("0123456789", first), text.size());
        if (end > first && end - first <= kMostConceptDigits)
            return std::string{text.substr(at, end - at)};
    }
    return std::nullopt;
}

SurfaceNotes notesIn(std::string_view text)
{
    SurfaceNotes notes;
    for (int i = 0; i < kCommentLinesRead && !text.empty(); ++i) {
        const auto comment = commentIn(takeLine(text));
        if (!comment)
            continue;
        if (const auto name = valueOf("English name", *comment))
            notes.name = *name;
        else if (const auto id = valueOf("Concept ID", *comment))
            notes.conceptId = *id;
        else if (isAttribution(*comment))
            notes.attributions.emplace_back(*comment);
    }
    return notes;
}

} // namespace carina
