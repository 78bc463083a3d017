#pragma once

#include "engine/core/result.h"

#include <QLineF>
#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <QStringList>

#include <filesystem>
#include <vector>

namespace carina
{

/// A piece of paper to cut out. Positions are millimetres to the right of and below its upper left
/// corner.
struct CutPiece {
    struct Hole {
        QPointF centre;
        double diameter = 0.0;
    };

    QString title{};
    QStringList steps{};           ///< how it is put together
    QSizeF size{};                 ///< that holds all of the following
    std::vector<QPolygonF> cuts{}; ///< lines, closed where they end where they begin
    std::vector<QLineF> folds{};
    std::vector<Hole> holes{};
    std::vector<QRectF> ink{}; ///< filled with black
};

/// Length of the bar by which a print is checked, millimetres.
inline constexpr double kScaleBar_mm = 100.0;

/// Writes pieces true to scale, one on each page of A4, with the bar below each.
/// @pre each piece fits into 180 mm by 215 mm.
/// @returns FileUnwritable
[[nodiscard]] Result<void> writeCuttingSheets(const std::filesystem::path& file,
                                              const std::vector<CutPiece>& pieces);

} // namespace carina
