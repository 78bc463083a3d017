#pragma once

#include "engine/registration/landmarks/landmark_catalogue.h"

#include <filesystem>
#include <string>

namespace carina
{

/// Reads a landmark catalogue from a file of another program, by its extension: .csv, .fcsv or
/// .mrk.json in upper or lower case (see landmark_text.h). Where the format has no name the
/// catalogue gets the file's.
///
/// @param anatomy content hash of the patient that the landmarks belong to; these formats do not
///        contain it
/// @returns FileNotFound, FileUnreadable, FileEmpty; UnknownFormat for another extension, or as the
///          format returns; FileMalformed where it does not follow its format or the catalogue is
///          invalid. The detail names file, line or field, and fault.
[[nodiscard]] Result<LandmarkCatalogue> importLandmarks(const std::filesystem::path& file,
                                                        std::string anatomy);

/// Writes a catalogue atomically, in the format of the file's extension.
/// @returns the errors of checkCatalogue; OutOfRange for a name of more than one line;
///          UnknownFormat; FileUnwritable
[[nodiscard]] Result<void> exportLandmarks(const std::filesystem::path& file,
                                           const LandmarkCatalogue& catalogue);

} // namespace carina
