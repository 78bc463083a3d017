#include "apps/lab/rendering/seen_balls.h"

#include <algorithm>

namespace carina::lab
{
namespace
{

constexpr int kFaintest = 16;   ///< of 255, of the strongest colour of a pixel that shows a ball
constexpr double kStrong = 0.6; ///< of the strongest colour

/// The mixture that a pixel shows, as bits for red, green and blue; 0 for black.
std::size_t mixtureOf(QRgb pixel)
{
    const std::array colors{qRed(pixel), qGreen(pixel), qBlue(pixel)};
    const int strongest = *std::ranges::max_element(colors);
    if (strongest < kFaintest)
        return 0;
    std::size_t mixture = 0;
    for (std::size_t color = 0; color < colors.size(); ++color)
        if (colors[color] > kStrong * strongest)
            mixture |= std::size_t{1} << color;
    return mixture;
}

} // namespace

QColor ballColor(std::size_t ball)
{
    const std::size_t mixture = ball + 1;
    const auto full = [mixture](std::size_t bit) { return (mixture & bit) != 0 ? 255 : 0; };
    return {full(1), full(2), full(4)};
}

std::array<BallPixels, kBallColors> ballsIn(const QImage& picture, const QRect& part)
{
    std::array<BallPixels, kBallColors> balls{};
    for (int y = part.top(); y <= part.bottom(); ++y)
        for (int x = part.left(); x <= part.right(); ++x)
            if (const std::size_t mixture = mixtureOf(picture.pixel(x, y)); mixture != 0) {
                BallPixels& ball = balls[mixture - 1];
                ++ball.count;
                ball.x += x + 0.5;
                ball.y += y + 0.5;
            }
    for (BallPixels& ball : balls) {
        ball.x /= std::max(1, ball.count);
        ball.y /= std::max(1, ball.count);
    }
    return balls;
}

} // namespace carina::lab
