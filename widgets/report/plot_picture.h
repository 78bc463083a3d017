#pragma once

#include <QByteArray>
#include <QString>

namespace carina
{

/// A figure's SVG rendered to PNG at twice its size in pixels, with a description as metadata. The
/// text depends on the installed fonts.
/// @pre svg is a result of svgOf(); there is a QGuiApplication, for its fonts.
[[nodiscard]] QByteArray pngOf(const QByteArray& svg, const QString& description);

} // namespace carina
