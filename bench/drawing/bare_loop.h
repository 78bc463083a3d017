#pragma once

#include "bench/drawing/patient_scene.h"

namespace carina::bench
{

/// Frames per second of a loop that only draws the patient, breathing, opaque and in full detail,
/// with the shaders of the product: no scene graph, no events, a constant index buffer. An
/// approximate upper limit for drawing these triangles with OpenGL.
///
/// @returns NoGraphics
[[nodiscard]] Result<double> bareLoopRate(const PatientScene& patient, double seconds);

/// Writes the triangles of bareLoopRate as one mesh with vertex colours, for other programs: binary
/// PLY, metres. @returns FileUnwritable
[[nodiscard]] Result<void> writePly(const PatientScene& patient, const std::filesystem::path& file);

} // namespace carina::bench
