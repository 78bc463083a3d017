#pragma once

#include <QColor>
#include <QImage>
#include <QRect>

#include <array>

namespace carina::lab
{

/// As many as there are mixtures of full or no red, green and blue, but for black.
inline constexpr std::size_t kBallColors = 7;

/// The colour by which a ball is told from the others.
[[nodiscard]] QColor ballColor(std::size_t ball);

/// All pixels of one ball.
struct BallPixels {
    int count = 0;
    double x = 0.0; ///< of their middle, pixels from the left edge of the picture
    double y = 0.0; ///< pixels from the top edge
};

/// The pixels of each ball within a part of a picture over black. A pixel is of the ball that has
/// the colours that are strong in it, however it is lit.
[[nodiscard]] std::array<BallPixels, kBallColors> ballsIn(const QImage& picture, const QRect& part);

} // namespace carina::lab
