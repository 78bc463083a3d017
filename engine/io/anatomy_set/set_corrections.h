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

/// What the import of a set makes of one surface, before it builds anything.
struct DraftSurface {
    std::string key; ///< "airway/trachea.obj: Trachea", its file and its name in there
    std::optional<PartRole> role = PartRole::Other; ///< nothing where it is left out
    std::size_t triangles = 0;
};

/// What the import of a set has read, to be looked through by a person.
struct SetDraft {
    std::vector<DraftSurface> surfaces;
    std::optional<SetFrame> frame; ///< nothing where no unit makes it a person
    std::vector<FileFault> faults;
};

/// What a person knows better than the import.
struct SetCorrections {
    /// By DraftSurface::key; nothing for a surface that is to be left out.
    std::map<std::string, std::optional<PartRole>> roles;
    std::optional<SetFrame> frame;

    [[nodiscard]] bool empty() const { return roles.empty() && !frame; }
};

/// Asked once all is read, before anything is built. @returns nothing to stop the import.
using SetReview = std::function<std::optional<SetCorrections>(const SetDraft& draft)>;

/// The axes of files by where +x, +y and +z point, as axisWords names them; nothing for words that
/// are not three axes of the body.
[[nodiscard]] std::optional<Mat3> axesFromWords(const std::vector<std::string>& words);

/// The content hash of files that were imported with corrections: with others they are another
/// patient. That of the files themselves without any.
[[nodiscard]] std::string correctedHash(const std::string& contentHashOfFiles,
                                        const SetCorrections& corrections);

/// Writes them as JSON, schema "carina.set-corrections/1": "roles", from keys to role names or
/// "left_out"; "unit_mm" and "axes" where they were given.
/// @returns FileUnwritable
[[nodiscard]] Result<void> writeCorrections(const std::filesystem::path& file,
                                            const SetCorrections& corrections);

/// The inverse.
/// @returns FileNotFound, FileUnreadable, FileEmpty; FileMalformed, UnknownFormat; the detail
/// begins
///          with the file.
[[nodiscard]] Result<SetCorrections> readCorrections(const std::filesystem::path& file);

} // namespace carina
