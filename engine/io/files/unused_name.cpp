#include "engine/io/files/unused_name.h"

#include <string>

namespace carina
{

std::filesystem::path unusedName(const std::filesystem::path& file)
{
    std::filesystem::path unused = file;
    std::error_code ignored;
    for (int number = 2; std::filesystem::exists(unused, ignored); ++number)
        unused.replace_filename(file.stem().string() + '-' + std::to_string(number)
                                + file.extension().string());
    return unused;
}

} // namespace carina
