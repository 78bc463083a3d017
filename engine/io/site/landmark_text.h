#pragma once

#include "engine/registration/landmarks/landmark_catalogue.h"

#include <string>
#include <string_view>

namespace carina
{

/// Landmarks as a table: a line of column names, then a line for each landmark.
///
///     name,x_mm,y_mm,z_mm
///     Sternal notch,0,-60.5,36
///
/// Columns may be in any order, other columns are ignored; x, y and z are in A. Fields may be
/// quoted, with "" for a quote within. Empty lines, a byte order mark and line ends of any system
/// are accepted.
/// @returns FileMalformed; the detail names line and column.
[[nodiscard]] Result<std::vector<Landmark>> decodeLandmarkTable(std::string_view text);
[[nodiscard]] std::string encodeLandmarkTable(const std::vector<Landmark>& landmarks);

/// Landmarks as a point list of 3D Slicer (.fcsv), millimetres in axes that the file names:
///
///     # Markups fiducial file version = 4.13
///     # CoordinateSystem = LPS
///     # columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID
///     1,0,-60.5,36,0,0,0,1,1,1,0,Sternal notch,,
///
/// LPS are the axes of A; RAS has x and y in the opposite direction. Slicer before 4.11 writes 0
/// for RAS and 1 for LPS. Slicer 5 adds two unnamed fields, of which the first is 2 for a point
/// that was placed. (slicer.readthedocs.io, Markups.) Encoding writes LPS and version 4.13.
/// @returns UnknownFormat for other axes; FileMalformed where axes or columns are not named, or a
///          point cannot be read or was not placed. The detail names the line.
[[nodiscard]] Result<std::vector<Landmark>> decodeSlicerPoints(std::string_view text);
[[nodiscard]] std::string encodeSlicerPoints(const std::vector<Landmark>& landmarks);

/// Landmarks as markups of 3D Slicer (.mrk.json, schema 1): label and position of each control
/// point of the only list of type Fiducial, in millimetres, LPS or RAS. The catalogue gets the name
/// of the list, if any, and no anatomy. Encoding writes schema 1.0.3, in LPS.
/// @returns UnknownFormat for another schema; FileMalformed where it is not JSON, has no such list
///          or several, is in another unit or other axes, or a point was not placed. The detail
///          names the field.
[[nodiscard]] Result<LandmarkCatalogue> decodeSlicerMarkups(std::string_view text);
[[nodiscard]] std::string encodeSlicerMarkups(const LandmarkCatalogue& catalogue);

} // namespace carina
