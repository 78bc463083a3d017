#include "engine/io/files/folder_path.h"

namespace carina
{

Result<std::filesystem::path> pathWithin(const std::filesystem::path& folder,
                                         const std::filesystem::path& name)
{
    const std::filesystem::path file = folder / name;
    std::error_code error;
    const auto whole = std::filesystem::canonical(folder.empty() ? "." : folder, error);
    const auto found = error ? std::filesystem::path{} : std::filesystem::canonical(file, error);
    if (error)
        return fail(Errc::FileNotFound, file.string() + ": no such file");
    const auto inside = found.lexically_relative(whole);
    if (inside.empty() || *inside.begin() == "..")
        return fail(Errc::FileUnreadable, file.string() + ": it leads out of its folder");
    return found;
}

} // namespace carina
