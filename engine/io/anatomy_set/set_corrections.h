#pragma once

#include "engine/io/anatomy_set/imported_set.h"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// One surface of a set as the import interprets it, before anything is built.
struct DraftSurface {
    std::string key; ///< file and name within it, such as "airway/trachea.obj: Trachea"
    std::optional<PartRole> role = PartRole::Other; ///< nothing where it is left out
    std::size_t triangles = 0;
};

/// What an import has read, for review by a person.
struct SetDraft {
    std::vector<DraftSurface> surfaces;
    std::optional<SetFrame> frame; ///< nothing where no unit gives the size of a person
    std::vector<FileFault> faults;
};

/// Corrections of an import by a person.
struct SetCorrections {
    /// New roles by DraftSurface::key; nothing for a surface to be left out.
    std::map<std::string, std::optional<PartRole>> roles;
    std::optional<SetFrame> frame;

    [[nodiscard]] bool empty() const { return roles.empty() && !frame; }
};

/// Called after all files are read and before anything is built. @returns nothing to cancel the
/// import.
using SetReview = std::function<std::optional<SetCorrections>(const SetDraft& draft)>;

/// The axes of files from words for +x, +y and +z, as in axisWords; nothing for words that are not
/// three axes of the body.
[[nodiscard]] std::optional<Mat3> axesFromWords(const std::vector<std::string>& words);

/// The content hash of a set imported with corrections: different corrections make a different
/// patient. Without corrections it is that of the files.
[[nodiscard]] std::string correctedHash(const std::string& contentHashOfFiles,
                                        const SetCorrections& corrections);

/// Writes them as JSON, schema "carina.set-corrections/1": "roles", from keys to role names or
/// "left_out"; "unit_mm" and "axes" where they were given.
/// @returns FileUnwritable
[[nodiscard]] Result<void> writeCorrections(const std::filesystem::path& file,
                                            const SetCorrections& corrections);

/// Inverse of writeCorrections.
/// @returns FileNotFound, FileUnreadable, FileEmpty; FileMalformed, UnknownFormat; the detail
///          begins with the file.
[[nodiscard]] Result<SetCorrections> readCorrections(const std::filesystem::path& file);

} // namespace carina
