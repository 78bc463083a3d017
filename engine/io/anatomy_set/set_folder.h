#pragma once

#include "engine/core/result.h"
#include "engine/io/anatomy_set/imported_set.h"

#include <filesystem>
#include <string>
#include <vector>

namespace carina
{

/// The files of a folder that belong to an anatomy set, found without opening them.
struct SetFolder {
    std::filesystem::path root;
    std::vector<std::string> surfaces; ///< files of a surface format, relative to root, sorted
    /// Other files that the import reads: MANIFEST.tsv, SOURCE.txt, buffers of glTF, materials of
    /// OBJ and textures; sorted.
    std::vector<std::string> companions;
};

/// Lists a folder and its subfolders.
/// @returns FileNotFound where there is no such folder; NothingRecognised where it has no surface.
[[nodiscard]] Result<SetFolder> listSetFolder(const std::filesystem::path& root);

/// SHA-256 in hexadecimal of the names and the bytes of all these files: equal for equal sets in
/// any location. A file that cannot be read counts as empty.
[[nodiscard]] std::string contentHashOf(const SetFolder& folder);

/// SHA-256 in hexadecimal of the paths of these files, their sizes and modification times: a change
/// of any file changes it, and it takes milliseconds.
[[nodiscard]] std::string listingHashOf(const SetFolder& folder);

/// Columns of a MANIFEST.tsv that are read.
inline constexpr std::size_t kMostManifestColumns = 64;
/// Missing files that are named.
inline constexpr std::size_t kMostMissingFiles = 1000;

/// Files that a MANIFEST.tsv of the folder lists in its column "file", and that do not exist in it.
/// Beyond kMostMissingFiles one more fault says that there are others.
[[nodiscard]] std::vector<FileFault> missingFiles(const SetFolder& folder);

/// The lines about licence and copyright in the SOURCE.txt of the folder.
[[nodiscard]] std::vector<std::string> attributionsBeside(const SetFolder& folder);

} // namespace carina
