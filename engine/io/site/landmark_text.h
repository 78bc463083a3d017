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
/// Columns in any order, others are passed over; x, y and z in A. Fields may be in quotes, with ""
/// for a quote in them. Empty lines, a byte order mark and line ends of any system are taken.
/// @returns FileMalformed; the detail names line and column.
[[nodiscard]] Result<std::vector<Landmark>> decodeLandmarkTable(std::string_view text);
[[nodiscard]] std::string encodeLandmarkTable(const std::vector<Landmark>& landmarks);

/// Landmarks as 3D Slicer's point list (.fcsv), millimetres in axes that the file names:
///
///     # Markups fiducial file version = 4.13
///     # CoordinateSystem = LPS
///     # columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID
///     1,0,-60.5,36,0,0,0,1,1,1,0,Sternal notch,,
///
/// LPS are the axes of A; RAS has x and y the other way. Slicer before 4.11 writes 0 for RAS and 1
/// for LPS. Slicer 5 adds two fields without a name, of which the first is 2 for a point that was
/// placed. (slicer.readthedocs.io, Markups.) Written are LPS and 4.13.
/// @returns UnknownFormat for other axes; FileMalformed where the axes or the columns are not
/// named,
///          or a point cannot be read or was not placed. The detail names the line.
[[nodiscard]] Result<std::vector<Landmark>> decodeSlicerPoints(std::string_view text);
[[nodiscard]] std::string encodeSlicerPoints(const std::vector<Landmark>& landmarks);

/// Landmarks as 3D Slicer's markups (.mrk.json, schema 1): the one list of type Fiducial in it, its
/// label and position of each control point, in millimetres, LPS or RAS. The catalogue has the
/// list's name, where it has one, and no anatomy. Written is schema 1.0.3, in LPS.
/// @returns UnknownFormat for another schema; FileMalformed where it is no JSON, has no such list
/// or
///          several, is in another unit or other axes, or a point was not placed. The detail names
///          the field.
[[nodiscard]] Result<LandmarkCatalogue> decodeSlicerMarkups(std::string_view text);
[[nodiscard]] std::string encodeSlicerMarkups(const LandmarkCatalogue& catalogue);

} // namespace carina
