#include "engine/tracking/sequence_fields.h"

namespace carina::field
{

namespace
{

constexpr std::string_view kBlank = " \t\r";

} // namespace

Result<std::ifstream> openFile(const std::filesystem::path& path)
{
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored))
        return fail(Errc::FileNotFound, path.string() + ": there is no such file");
    if (std::filesystem::is_directory(path, ignored))
        return fail(Errc::FileUnreadable, path.string() + ": it is a folder");
    std::ifstream input{path, std::ios::binary};
    if (!input)
        return fail(Errc::FileUnreadable, path.string() + ": it cannot be read");
    return input;
}

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::string_view lastWord(std::string_view text)
{
    text = trimmed(text);
    return text.substr(text.find_last_of(kBlank) + 1);
}

std::optional<Mat4> matrixOf(std::string_view text)
{
    Mat4 matrix;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            text = trimmed(text);
            const std::string_view word = text.substr(0, text.find_first_of(kBlank));
            const std::optional<double> value = numberOf<double>(word);
            if (!value)
                return std::nullopt;
            matrix(row, column) = *value;
            text.remove_prefix(word.size());
        }
    }
    if (!trimmed(text).empty())
        return std::nullopt;
    return matrix;
}

std::optional<Validity> validityOf(std::string_view status)
{
    if (status == "OK")
        return Validity::Tracked;
    for (const std::string_view lost :
         {"MISSING", "INVALID", "OUT_OF_VIEW", "OUT_OF_VOLUME", "REQ_TIMEOUT"}) {
        if (status == lost)
            return Validity::Lost;
    }
    return std::nullopt;
}

} // namespace carina::field
