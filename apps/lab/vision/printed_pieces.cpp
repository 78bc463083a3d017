#include "apps/lab/vision/printed_pieces.h"

#include <QCoreApplication>

namespace carina::lab
{
namespace
{

constexpr double kFlap_mm = 8.0;

class PieceWords
{
    Q_DECLARE_TR_FUNCTIONS(PrintedPieces)

public:
    static QString sheetTitle(const PrintedTool& tool)
    {
        return tool.role == ToolRole::Jaw ? tr("Chin") : tr("Chest");
    }
    static QStringList sheetSteps(const PrintedTool& tool)
    {
        return {tr("Glue the sheet onto stiff cardboard and keep it flat."),
                tool.role == ToolRole::Jaw
                    ? tr("Fix it to the manikin's chin, where it moves with the jaw.")
                    : tr("Fix it to the manikin's chest, where the camera always sees it.")};
    }

    static QString sleeveTitle(const PrintedTool& tool)
    {
        switch (tool.role) {
        case ToolRole::Tube:
            return tr("Tube");
        case ToolRole::Stylus:
            return tr("Stylus");
        default:
            return tr("Laryngoscope");
        }
    }
    static QString place(const PrintedTool& tool)
    {
        switch (tool.role) {
        case ToolRole::Tube:
            return tr(
                "Push it over the tube's connector, the strip's upper edge away from the "
                "patient, and glue it on. The face with the ends looks to the patient's left, when "
                "the tube's curve lies as in the mouth.");
        case ToolRole::Stylus:
            return tr("Push a pencil through both holes, with the tip out of the lower end, and "
                      "glue it in.");
        default:
            return tr("Push it over the handle, above the fingers, and glue it on.");
        }
    }
    static QStringList sleeveSteps(const PrintedTool& tool)
    {
        return {tr("Fold the strip to a box with the markers outside, and glue the flap behind the "
                   "first face."),
                tr("Cut out the holes of both ends, fold the ends in and glue their flaps."),
                place(tool)};
    }

    static QString boardTitle() { return tr("Board to calibrate the camera"); }
    static QStringList boardSteps()
    {
        return {tr("Glue the sheet onto something stiff and flat: a wavy board spoils the "
                   "calibration.")};
    }
};

/// The outline of a flap with slanted ends along an edge from a to b, to its left as it is walked
/// along, without that edge.
QPolygonF flapAlong(const QPointF& a, const QPointF& b)
{
    const QLineF edge{a, b};
    const QPointF along = (b - a) / edge.length();
    const QPointF out{along.y(), -along.x()};
    const double slant = 0.6 * kFlap_mm;
    return QPolygonF{QList<QPointF>{a, a + kFlap_mm * out + slant * along,
                                    b + kFlap_mm * out - slant * along, b}};
}

QPolygonF lineBetween(const QPointF& a, const QPointF& b)
{
    return QPolygonF{QList<QPointF>{a, b}};
}

/// Cells that are black, those beside each other in a row as one.
void addCells(CutPiece& piece, const std::vector<bool>& cells, int columns, const QRectF& place)
{
    const int rows = int(cells.size()) / columns;
    const double width = place.width() / columns;
    const double height = place.height() / rows;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns;) {
            int end = column;
            while (end < columns && !cells[std::size_t(row * columns + end)])
                ++end;
            if (end > column)
                piece.ink.push_back({place.left() + column * width, place.top() + row * height,
                                     (end - column) * width, height});
            column = std::max(end, column + 1);
        }
}

void addMarker(CutPiece& piece, int id, const QPointF& middle, double side)
{
    addCells(piece, cellsOf(kPrintedDictionary, id), cellsOf(kPrintedDictionary),
             {middle.x() - 0.5 * side, middle.y() - 0.5 * side, side, side});
}

CutPiece sheetOf(const PrintedTool& tool)
{
    const QSizeF size{inMillimetres(tool.width), inMillimetres(tool.height)};
    CutPiece piece{
        .title = PieceWords::sheetTitle(tool), .steps = PieceWords::sheetSteps(tool), .size = size};
    piece.cuts.push_back(QPolygonF{QRectF{QPointF{0.0, 0.0}, size}});
    for (const BodyMarker& marker : tool.body) {
        const Vec3 p_mm = 1e3 * marker.X_BK.translation();
        addMarker(piece, marker.id, {0.5 * size.width() + p_mm.x(), 0.5 * size.height() - p_mm.y()},
                  1e3 * marker.side);
    }
    return piece;
}

/// An end with a hole and three flaps, above or below the first face.
void addEnd(CutPiece& piece, const QRectF& end, bool isAbove, double hole)
{
    const QPointF corners[]{end.topLeft(), end.topRight(), end.bottomRight(), end.bottomLeft()};
    for (int i = 0; i < 4; ++i) {
        if (i == (isAbove ? 2 : 0)) // the edge to the face
            continue;
        const QPointF& a = corners[i];
        const QPointF& b = corners[(i + 1) % 4];
        piece.cuts.push_back(flapAlong(a, b));
        piece.folds.emplace_back(a, b);
    }
    piece.folds.push_back(isAbove ? QLineF{end.bottomLeft(), end.bottomRight()}
                                  : QLineF{end.topLeft(), end.topRight()});
    piece.holes.push_back({end.center(), hole});
}

CutPiece sleeveOf(const PrintedTool& tool)
{
    const double face = inMillimetres(tool.width);
    const double height = inMillimetres(tool.height);
    const double left = kFlap_mm; // room for the flaps of the ends
    const double top = kFlap_mm + face;
    CutPiece piece{.title = PieceWords::sleeveTitle(tool),
                   .steps = PieceWords::sleeveSteps(tool),
                   .size = {left + 4.0 * face + kFlap_mm, top + height + face + kFlap_mm}};
    const double right = left + 4.0 * face;
    const double bottom = top + height;
    for (int i = 0; i < 4; ++i) {
        const double x = left + i * face;
        piece.folds.emplace_back(x + face, top, x + face, bottom);
        addMarker(piece, tool.body[std::size_t(i)].id, {x + 0.5 * face, top + 0.5 * height},
                  1e3 * tool.body[std::size_t(i)].side);
    }
    piece.cuts.push_back(lineBetween({left, top}, {left, bottom}));
    for (const double y : {top, bottom}) // the ends hang on the first face
        piece.cuts.push_back(lineBetween({left + face, y}, {right, y}));
    piece.cuts.push_back(flapAlong({right, top}, {right, bottom}));
    addEnd(piece, {left, top - face, face, face}, true, inMillimetres(tool.hole));
    addEnd(piece, {left, bottom, face, face}, false, inMillimetres(tool.hole));
    return piece;
}

} // namespace

CutPiece pieceOf(const PrintedTool& tool) { return tool.isSleeve ? sleeveOf(tool) : sheetOf(tool); }

CutPiece pieceOf(const CalibrationBoard& board)
{
    constexpr double kMargin_mm = 5.0;
    const QSizeF squares{1e3 * board.square * board.columns, 1e3 * board.square * board.rows};
    CutPiece piece{.title = PieceWords::boardTitle(),
                   .steps = PieceWords::boardSteps(),
                   .size = squares + QSizeF{2.0 * kMargin_mm, 2.0 * kMargin_mm}};
    addCells(piece, cellsOf(board), board.columns * kCellsOfSquare,
             {QPointF{kMargin_mm, kMargin_mm}, squares});
    return piece;
}

} // namespace carina::lab
