#pragma once

#include "engine/core/result.h"
#include "engine/io/anatomy_set/imported_set.h"

#include <filesystem>
#include <string>
#include <vector>

namespace carina
{

/// The files of a folder that make up an anatomy set, found without opening them.
struct SetFolder {
    std::filesystem::path root;
    std::vector<std::string> surfaces; ///< files of a surface format, relative to root, sorted
    /// What else the import reads: MANIFEST.tsv, SOURCE.txt, the buffers of glTF, the materials of
    /// OBJ and textures; sorted.
    std::vector<std::string> companions;
};

/// Lists a folder and the folders below it.
/// @returns FileNotFound when there is no such folder; NothingRecognised without a single surface.
[[nodiscard]] Result<SetFolder> listSetFolder(const std::filesystem::path& root);

/// SHA-256 in hex over the names and the bytes of all these files: equal for equal sets wherever
/// they lie. A file that cannot be read counts as empty.
[[nodiscard]] std::string contentHashOf(const SetFolder& folder);

/// SHA-256 in hex over where these files lie, their sizes and when they were last written: changes
/// when any of them does, and takes milliseconds.
[[nodiscard]] std::string listingHashOf(const SetFolder& folder);

/// Files that a MANIFEST.tsv of the folder names in its column "file" and that are not below it.
[[nodiscard]] std::vector<FileFault> missingFiles(const SetFolder& folder);

/// The lines about licence and copyright in the SOURCE.txt of the folder.
[[nodiscard]] std::vector<std::string> attributionsBeside(const SetFolder& folder);

} // namespace carina
