#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/tracking/markers/probe.h"

#include <string>

namespace carina::lab
{

/// A probe as a solid to be printed: a ball about the middle of the markers, with a bore of 6.4 mm
/// along -z of O for a pin, and a rod to each marker that ends in a flat seat across its normal.
/// @param seat distance from the seat to the middle of the marker
/// @returns a closed mesh in O, metres, that faces outward.
[[nodiscard]] TriangleMesh solidOf(const Probe& probe, Length seat);

/// A mesh as the bytes of a binary STL file, in millimetres.
[[nodiscard]] std::string stlOf(const TriangleMesh& mesh_O, const std::string& name);

} // namespace carina::lab
