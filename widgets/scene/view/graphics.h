#pragma once

#include "engine/core/result.h"

#include <QString>

namespace carina
{

/// Sets how all views of this program draw: Qt 3D on OpenGL 3.3 core, without multisampling (which
/// would be Qt 3D's default and cost three quarters of the frames on a software renderer) and
/// without waiting for the screen in each of several views.
///
/// @pre called before the QGuiApplication is made.
void prepareGraphics();

/// The renderer name of the OpenGL driver: "llvmpipe (LLVM 15.0.6, 256 bits)".
///
/// @returns NoGraphics if no OpenGL 3.3 core context can be created.
/// @pre there is a QGuiApplication.
[[nodiscard]] Result<QString> graphicsDriver();

} // namespace carina
