#pragma once

#include "engine/vision/board_calibration.h"
#include "evaluation/vision/marker_renderer.h"
#include "evaluation/vision/video_writer.h"
#include "tests/engine/vision/vision_bench.h"

#include <QDir>

#include <random>

namespace carina::vision_test
{

/// Writes pictures of the printed board into a folder, all over the picture and tilted to all
/// sides.
/// @returns whether all were written.
inline bool writeBoards(const QString& folder, int count)
{
    const CalibrationBoard board;
    MarkerRenderer renderer{webcam(), board.dictionary, {.samples = 2}};
    std::mt19937 random{7};
    std::uniform_real_distribution<double> share{-1.0, 1.0};
    for (int i = 0; i < count; ++i) {
        const double across = 0.75 * share(random);
        const double down = 0.75 * share(random);
        const Vec2 middle{320.0 * (1.0 + across), 240.0 * (1.0 + down)};
        const Vec3 p_T = (0.35 + 0.08 * share(random)) * sightOf(webcam(), middle).normalized();
        const double tilt_deg = 35.0 * (i % 2 ? 1 : -1);
        const double direction_deg = 180.0 * share(random);
        const double turn_deg = 90.0 * share(random);
        const RigidTransform X_TK = facing(p_T, tilt_deg, direction_deg, turn_deg);
        const auto file =
            QDir{folder}.filePath(QStringLiteral("%1.png").arg(i, 3, 10, QLatin1Char{'0'}));
        if (!writePicture(file.toStdString(),
                          renderer.drawBoard({cellsOf(board), board.columns * kCellsOfSquare,
                                              board.square / kCellsOfSquare, X_TK})))
            return false;
    }
    return true;
}

} // namespace carina::vision_test
