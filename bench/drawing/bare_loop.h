#pragma once

#include "bench/drawing/patient_scene.h"

namespace carina::bench
{

/// Frames per second of a loop that does nothing but draw the patient, breathing, opaque and in
/// full detail, with the shaders of the product: no scene, no events, no list of corners that
/// changes. Nobody who draws these triangles with OpenGL can be much faster.
///
/// @returns NoGraphics
[[nodiscard]] Result<double> bareLoopRate(const PatientScene& patient, double seconds);

/// The triangles that it draws as one mesh, with a colour for each vertex, for other programs:
/// binary PLY, metres. @returns FileUnwritable
[[nodiscard]] Result<void> writePly(const PatientScene& patient, const std::filesystem::path& file);

} // namespace carina::bench
