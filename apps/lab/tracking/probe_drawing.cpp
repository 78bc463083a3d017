#include "apps/lab/tracking/probe_drawing.h"

#include <QString>

#include <algorithm>
#include <array>

namespace carina::lab
{
namespace
{

// Millimetres on the paper.
constexpr double kPaperWidth = 210.0;
constexpr double kPaperHeight = 297.0;
constexpr double kViewEdge = 84.0; ///< edge of the square of a view
constexpr double kPaperMargin = 14.0;
constexpr double kMarkerDot = 2.2; ///< radius of a marker
constexpr double kTableRow = 4.6;

/// A view along an axis that comes out of the paper.
struct ViewAlong {
    const char* name;
    Vec3 right;
    Vec3 up;
    Vec3 toward;
};

const std::array kViewsAlong{
    ViewAlong{"along z: x to the right, y up", Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()},
    ViewAlong{"along -y: x to the right, z up", Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitY()},
    ViewAlong{"along x: y to the right, z up", Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitX()}};

QString svgText(double x, double y, const QString& words, double size = 3.2)
{
    return QStringLiteral("<svgText x=\"%1\" y=\"%2\" font-size=\"%3\">%4</svgText>\n")
        .arg(x, 0, 'f', 2)
        .arg(y, 0, 'f', 2)
        .arg(size, 0, 'f', 2)
        .arg(words.toHtmlEscaped());
}

QString svgMarker(std::size_t number, const Vec3& place, bool isHollow)
{
    return QStringLiteral("<circle cx=\"%1\" cy=\"%2\" r=\"%3\" fill=\"%4\"%5/>\n")
               .arg(place.x(), 0, 'f', 2)
               .arg(place.y(), 0, 'f', 2)
               .arg(kMarkerDot)
               .arg(isHollow ? QStringLiteral("white") : QStringLiteral("#404040"))
               .arg(isHollow ? QStringLiteral(" stroke-dasharray=\"0.8 0.8\"") : QString{})
           + svgText(place.x() + kMarkerDot + 0.5, place.y() + 1.1, QString::number(number), 2.8);
}

QString svgView(const ViewAlong& view, const Probe& probe, double scale, double left, double top)
{
    const Vec3 centre{left + kViewEdge / 2.0, top + kViewEdge / 2.0, 0.0};
    QString svg = svgText(left, top - 1.5, QString::fromLatin1(view.name));
    svg += QStringLiteral("<path d=\"M%1 %2h%3M%4 %5v%3\" stroke-width=\"0.15\"/>\n")
               .arg(left)
               .arg(centre.y())
               .arg(kViewEdge)
               .arg(centre.x())
               .arg(top);
    for (std::size_t i = 0; i < probe.markers.size(); ++i) {
        const ToolMarker& each = probe.markers[i];
        const Vec3 place =
            centre + 1e3 * scale * Vec3{each.p_OQ.dot(view.right), -each.p_OQ.dot(view.up), 0.0};
        svg += svgMarker(i + 1, place, !faces(each, view.toward, probe.largestAngle));
    }
    return svg;
}

QString svgTable(const Probe& probe, double left, double top)
{
    QString svg = svgText(left, top, QStringLiteral("marker: x, y, z in mm"));
    for (std::size_t i = 0; i < probe.markers.size(); ++i) {
        const Vec3 p = 1e3 * probe.markers[i].p_OQ;
        svg += svgText(left, top + kTableRow * double(i + 1),
                       QStringLiteral("%1: %2, %3, %4")
                           .arg(i + 1)
                           .arg(p.x(), 0, 'f', 2)
                           .arg(p.y(), 0, 'f', 2)
                           .arg(p.z(), 0, 'f', 2));
    }
    return svg;
}

} // namespace

std::string drawingOf(const Probe& probe, const std::string& title)
{
    double extent = 1e-3;
    for (const ToolMarker& each : probe.markers)
        extent = std::max(extent, each.p_OQ.cwiseAbs().maxCoeff());
    const double scale = std::min(1.0, (kViewEdge / 2.0 - 2.0 * kMarkerDot) / (1e3 * extent));
    const double second = kPaperMargin + kViewEdge + kPaperMargin;
    QString svg =
        QStringLiteral("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%1mm\" "
                       "height=\"%2mm\" viewBox=\"0 0 %1 %2\">\n"
                       "<rect width=\"%1\" height=\"%2\" fill=\"white\"/>\n"
                       "<g font-family=\"sans-serif\" stroke=\"black\" stroke-width=\"0\">\n")
            .arg(kPaperWidth)
            .arg(kPaperHeight);
    svg += svgText(kPaperMargin, kPaperMargin, QString::fromStdString(title), 5.0);
    svg += svgText(
        kPaperMargin, kPaperMargin + 6.0,
        QStringLiteral("Scale 1 : %1. Hollow markers face away.").arg(1.0 / scale, 0, 'f', 2));
    svg += QStringLiteral("<g stroke-width=\"0.25\">\n");
    const double top = kPaperMargin + 18.0;
    svg += svgView(kViewsAlong[0], probe, scale, kPaperMargin, top);
    svg += svgView(kViewsAlong[2], probe, scale, second, top);
    svg += svgView(kViewsAlong[1], probe, scale, kPaperMargin, top + kViewEdge + kPaperMargin);
    svg += QStringLiteral("</g>\n");
    svg += svgTable(probe, second, top + kViewEdge + kPaperMargin);
    svg += QStringLiteral("</g>\n</svg>\n");
    return svg.toStdString();
}

} // namespace carina::lab
