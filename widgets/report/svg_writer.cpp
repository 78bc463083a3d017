#include "widgets/report/svg_writer.h"

#include <array>
#include <cmath>

namespace carina
{
namespace
{

/// From the middle of a line down to its base, in heights of the font: half of a capital's height.
constexpr double kBase = 0.36;

/// In hundredths, and never "-0".
QString svgNumber(double value) { return QString::number(std::round(value * 100.0) / 100.0 + 0.0); }

QString attribute(const char* name) { return QString::fromLatin1(name); }

} // namespace

QString svgPoint(const QPointF& point)
{
    return svgNumber(point.x()) + QLatin1Char{','} + svgNumber(point.y());
}

SvgWriter::SvgWriter(const QSizeF& size, const QString& title, const QString& description)
{
    m_xml.setAutoFormatting(true);
    m_xml.setAutoFormattingIndent(1);
    m_xml.writeStartDocument();
    m_xml.writeStartElement(attribute("svg"));
    m_xml.writeDefaultNamespace(QStringLiteral("http://www.w3.org/2000/svg"));
    m_xml.writeAttribute(attribute("width"), svgNumber(size.width()));
    m_xml.writeAttribute(attribute("height"), svgNumber(size.height()));
    m_xml.writeAttribute(
        attribute("viewBox"),
        QStringLiteral("0 0 %1 %2").arg(svgNumber(size.width())).arg(svgNumber(size.height())));
    m_xml.writeAttribute(attribute("font-family"), QStringLiteral("DejaVu Sans, sans-serif"));
    m_xml.writeTextElement(attribute("title"), title);
    m_xml.writeTextElement(attribute("desc"), description);
}

void SvgWriter::rectangle(const QRectF& rectangle, const QString& fill, const SvgStroke& stroke)
{
    m_xml.writeEmptyElement(attribute("rect"));
    m_xml.writeAttribute(attribute("x"), svgNumber(rectangle.x()));
    m_xml.writeAttribute(attribute("y"), svgNumber(rectangle.y()));
    m_xml.writeAttribute(attribute("width"), svgNumber(rectangle.width()));
    m_xml.writeAttribute(attribute("height"), svgNumber(rectangle.height()));
    m_xml.writeAttribute(attribute("fill"), fill);
    writeStroke(stroke);
}

void SvgWriter::polyline(const std::vector<QPointF>& points, const SvgStroke& stroke)
{
    QString pairs;
    for (const QPointF& point : points)
        pairs += (pairs.isEmpty() ? QString{} : QStringLiteral(" ")) + svgPoint(point);
    m_xml.writeEmptyElement(attribute("polyline"));
    m_xml.writeAttribute(attribute("points"), pairs);
    m_xml.writeAttribute(attribute("fill"), QStringLiteral("none"));
    writeStroke(stroke);
}

void SvgWriter::path(const QString& outline, const QString& fill, const SvgStroke& stroke)
{
    m_xml.writeEmptyElement(attribute("path"));
    m_xml.writeAttribute(attribute("d"), outline);
    m_xml.writeAttribute(attribute("fill"), fill);
    writeStroke(stroke);
}

void SvgWriter::text(const QPointF& at, const QString& words, const SvgText& style)
{
    static constexpr std::array kAnchors{"start", "middle", "end"};
    m_xml.writeStartElement(attribute("text"));
    if (style.isUpwards) {
        m_xml.writeAttribute(attribute("transform"),
                             QStringLiteral("translate(%1) rotate(-90)").arg(svgPoint(at)));
        m_xml.writeAttribute(attribute("y"), svgNumber(kBase * style.pixels));
    } else {
        m_xml.writeAttribute(attribute("x"), svgNumber(at.x()));
        m_xml.writeAttribute(attribute("y"), svgNumber(at.y() + kBase * style.pixels));
    }
    m_xml.writeAttribute(attribute("font-size"), svgNumber(style.pixels));
    m_xml.writeAttribute(attribute("text-anchor"),
                         QString::fromLatin1(kAnchors[static_cast<std::size_t>(style.anchor)]));
    m_xml.writeAttribute(attribute("fill"), style.colour);
    m_xml.writeCharacters(words);
    m_xml.writeEndElement();
}

QByteArray SvgWriter::finish()
{
    m_xml.writeEndDocument();
    return m_bytes;
}

void SvgWriter::writeStroke(const SvgStroke& stroke)
{
    m_xml.writeAttribute(attribute("stroke"),
                         stroke.colour.isEmpty() ? QStringLiteral("none") : stroke.colour);
    if (stroke.colour.isEmpty())
        return;
    m_xml.writeAttribute(attribute("stroke-width"), svgNumber(stroke.width));
    if (!stroke.dashes.isEmpty())
        m_xml.writeAttribute(attribute("stroke-dasharray"), stroke.dashes);
}

} // namespace carina
