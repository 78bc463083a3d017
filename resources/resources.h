#pragma once

#include <QByteArray>

namespace carina
{

/// A compiled-in file by its name below resources/, such as "shaders/organ.vert".
///
/// @pre the file is listed in resources/CMakeLists.txt.
[[nodiscard]] QByteArray resource(const char* name);

} // namespace carina
