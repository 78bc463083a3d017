#include "widgets/report/cutting_sheet.h"

#include "engine/core/expects.h"
#include "widgets/report/page_flow.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <QSaveFile>

namespace carina
{
namespace
{

constexpr QMarginsF kSheetMargins_mm{15.0, 12.0, 15.0, 12.0};
constexpr QSizeF kLargestPiece_mm{180.0, 215.0};
constexpr double kCutLine = pageDots(0.2);
const PageTextStyle kPieceTitle{.points = 14.0, .isBold = true};

class SheetWords
{
    Q_DECLARE_TR_FUNCTIONS(CuttingSheet)

public:
    static QString title() { return tr("Markers for Carina"); }
    static QString bar()
    {
        return tr("This bar is %1 mm long. If it is not, print again at 100 % (actual size), not "
                  "fitted to the page.")
            .arg(kScaleBar_mm);
    }
    static QString lines() { return tr("Cut along the full lines, fold along the dashed ones."); }
    static QString page(int page, std::size_t of) { return tr("%1 of %2").arg(page).arg(of); }
};

void drawPiece(QPainter& painter, const CutPiece& piece, const QPointF& corner)
{
    painter.save();
    painter.translate(corner);
    painter.scale(pageDots(1.0), pageDots(1.0));
    painter.setRenderHint(QPainter::Antialiasing, false);
    QPainterPath ink; // filled at once, so that no seam shows between two cells
    ink.setFillRule(Qt::WindingFill);
    for (const QRectF& cell : piece.ink)
        ink.addRect(cell);
    painter.fillPath(ink, Qt::black);
    painter.setPen(QPen{Qt::black, kCutLine / pageDots(1.0)});
    for (const QPolygonF& cut : piece.cuts)
        painter.drawPolyline(cut);
    for (const CutPiece::Hole& hole : piece.holes) {
        const double radius = 0.5 * hole.diameter;
        painter.drawEllipse(hole.centre, radius, radius);
    }
    painter.setPen(QPen{Qt::darkGray, kCutLine / pageDots(1.0), Qt::DashLine});
    for (const QLineF& fold : piece.folds)
        painter.drawLine(fold);
    painter.restore();
}

void drawBar(QPainter& painter, const QRectF& place)
{
    const double length = pageDots(kScaleBar_mm);
    const double tick = pageDots(2.0);
    painter.setPen(QPen{Qt::black, pageDots(0.3), Qt::SolidLine, Qt::FlatCap});
    const QPointF from{place.left() + pageDots(0.15), place.center().y()};
    const QPointF to = from + QPointF{length, 0.0};
    painter.drawLine(from, to);
    for (const QPointF& end : {from, to})
        painter.drawLine(end - QPointF{0.0, tick}, end + QPointF{0.0, tick});
}

/// @returns false where nothing can be drawn; whether all was written, the device tells.
bool drawSheets(QIODevice& device, const std::vector<CutPiece>& pieces)
{
    QPdfWriter writer{&device};
    writer.setResolution(kPageDotsPerInch);
    writer.setPageSize(QPageSize{QPageSize::A4});
    writer.setPageMargins(kSheetMargins_mm, QPageLayout::Millimeter);
    writer.setTitle(SheetWords::title());
    writer.setCreator(QStringLiteral("Carina"));
    QPainter painter;
    if (!painter.begin(&writer))
        return false;
    PageFlow flow{writer, painter, SheetWords::title(),
                  [&](int page) { return SheetWords::page(page, pieces.size()); }};
    for (const CutPiece& piece : pieces) {
        if (&piece != &pieces.front())
            flow.beginPage();
        flow.addText(piece.title, kPieceTitle);
        for (const QString& step : piece.steps)
            flow.addText(step);
        if (!piece.folds.empty())
            flow.addText(SheetWords::lines());
        flow.skip(pageDots(3.0));
        flow.add(pageDots(piece.size.height()),
                 [&](QPainter& on, const QRectF& place) { drawPiece(on, piece, place.topLeft()); });
        flow.skip(pageDots(3.0));
        flow.add(pageDots(5.0), drawBar);
        flow.addText(SheetWords::bar());
    }
    return painter.end();
}

} // namespace

Result<void> writeCuttingSheets(const std::filesystem::path& file,
                                const std::vector<CutPiece>& pieces)
{
    for (const CutPiece& piece : pieces)
        CARINA_EXPECTS(piece.size.width() <= kLargestPiece_mm.width()
                       && piece.size.height() <= kLargestPiece_mm.height());
    QSaveFile target{QString::fromStdString(file.string())};
    if (!target.open(QIODevice::WriteOnly) || !drawSheets(target, pieces) || !target.commit())
        return fail(Errc::FileUnwritable, file.string() + ": cannot be written");
    return {};
}

} // namespace carina
