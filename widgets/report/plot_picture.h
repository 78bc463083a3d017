#pragma once

#include <QByteArray>
#include <QString>

namespace carina
{

/// A PNG file of a figure's SVG at twice its pixels, with a description in it. Its letters are of
/// the fonts there are.
/// @pre svg is svgOf() a plot, and there is a QGuiApplication, for its fonts.
[[nodiscard]] QByteArray pngOf(const QByteArray& svg, const QString& description);

} // namespace carina
