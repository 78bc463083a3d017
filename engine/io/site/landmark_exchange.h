#pragma once

#include "engine/registration/landmarks/landmark_catalogue.h"

#include <filesystem>
#include <string>

namespace carina
{

/// Reads a catalogue from a file of another program, by its ending: .csv, .fcsv or .mrk.json in
/// letters of any case (see landmark_text.h). A format without a name gives it the file's.
///
/// @param anatomy content hash of the patient that the landmarks are of: no such file names it
/// @returns FileNotFound, FileUnreadable, FileEmpty; UnknownFormat for another ending, or what the
///          format returns; FileMalformed where it does not follow its format or the catalogue
///          cannot be used. The detail names file, line or field, and fault.
[[nodiscard]] Result<LandmarkCatalogue> importLandmarks(const std::filesystem::path& file,
                                                        std::string anatomy);

/// Writes one, whole or not at all, in the format of the file's ending.
/// @returns what checkCatalogue returns; OutOfRange for a name of more than one line;
///          UnknownFormat; FileUnwritable
[[nodiscard]] Result<void> exportLandmarks(const std::filesystem::path& file,
                                           const LandmarkCatalogue& catalogue);

} // namespace carina
