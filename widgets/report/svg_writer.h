#pragma once

#include <QByteArray>
#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QString>
#include <QXmlStreamWriter>

#include <vector>

namespace carina
{

struct SvgStroke {
    QString colour{};
    double width = 1.0; ///< pixels
    QString dashes{};   ///< alternating lengths of dashes and gaps, pixels; empty for a solid line
};

struct SvgText {
    enum class Anchor { Start, Middle, End };

    double pixels = 16.0;
    QString colour{};
    Anchor anchor = Anchor::Start;
    bool isUpwards = false; ///< rotated to read upwards
};

/// A coordinate pair in SVG syntax, rounded to hundredths of a pixel.
[[nodiscard]] QString svgPoint(const QPointF& point);

/// Writes one SVG 1.1 drawing from back to front. It uses no font metrics: a text is placed by its
/// anchor, so that the same calls give the same bytes on every system.
class SvgWriter
{
public:
    SvgWriter(const QSizeF& size, const QString& title, const QString& description);

    void rectangle(const QRectF& rectangle, const QString& fill, const SvgStroke& stroke);
    void polyline(const std::vector<QPointF>& points, const SvgStroke& stroke);
    /// @param outline path data of SVG
    void path(const QString& outline, const QString& fill, const SvgStroke& stroke);
    /// @param at the anchor, vertically in the middle of the line
    void text(const QPointF& at, const QString& words, const SvgText& style);

    /// Ends the drawing. @returns its bytes, in UTF-8.
    [[nodiscard]] QByteArray finish();

private:
    void writeStroke(const SvgStroke& stroke);

    QByteArray m_bytes;
    QXmlStreamWriter m_xml{&m_bytes};
};

} // namespace carina
