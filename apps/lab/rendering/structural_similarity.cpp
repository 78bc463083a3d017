#include "apps/lab/rendering/structural_similarity.h"

#include "engine/core/expects.h"

#include <array>
#include <cmath>
#include <vector>

namespace carina::lab
{
namespace
{

constexpr int kReach = 5; ///< of a window, pixels to each side of its middle
constexpr int kWindow = 2 * kReach + 1;
constexpr double kSigma = 1.5; ///< pixels
constexpr double kMostLuma = 255.0;
constexpr double kC1 = 0.01 * kMostLuma * 0.01 * kMostLuma;
constexpr double kC2 = 0.03 * kMostLuma * 0.03 * kMostLuma;

using WindowWeights = std::array<double, kWindow>;

/// Of one direction; the product of two of them is a window's.
WindowWeights gaussianWeights()
{
    WindowWeights weights{};
    double sum = 0.0;
    for (int i = 0; i < kWindow; ++i) {
        const double away = (i - kReach) / kSigma;
        weights[std::size_t(i)] = std::exp(-0.5 * away * away);
        sum += weights[std::size_t(i)];
    }
    for (double& weight : weights)
        weight /= sum;
    return weights;
}

/// A value for each pixel, row by row from the top.
struct ValueMap {
    int width = 0;
    int height = 0;
    std::vector<double> values{};

    ValueMap(int columns, int rows)
        : width{columns}, height{rows}, values(std::size_t(columns) * std::size_t(rows))
    {
    }
    [[nodiscard]] double& at(int x, int y)
    {
        return values[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
    [[nodiscard]] double at(int x, int y) const
    {
        return values[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
};

ValueMap lumaOf(const QImage& image)
{
    ValueMap map{image.width(), image.height()};
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const QRgb pixel = image.pixel(x, y);
            map.at(x, y) = 0.299 * qRed(pixel) + 0.587 * qGreen(pixel) + 0.114 * qBlue(pixel);
        }
    return map;
}

ValueMap productOf(const ValueMap& a, const ValueMap& b)
{
    ValueMap map{a.width, a.height};
    for (std::size_t i = 0; i < map.values.size(); ++i)
        map.values[i] = a.values[i] * b.values[i];
    return map;
}

/// The weighted mean in each window that is wholly inside.
ValueMap windowMeans(const ValueMap& map)
{
    const WindowWeights weights = gaussianWeights();
    ValueMap along{map.width - 2 * kReach, map.height};
    for (int y = 0; y < along.height; ++y)
        for (int x = 0; x < along.width; ++x)
            for (int i = 0; i < kWindow; ++i)
                along.at(x, y) += weights[std::size_t(i)] * map.at(x + i, y);
    ValueMap means{along.width, map.height - 2 * kReach};
    for (int y = 0; y < means.height; ++y)
        for (int x = 0; x < means.width; ++x)
            for (int i = 0; i < kWindow; ++i)
                means.at(x, y) += weights[std::size_t(i)] * along.at(x, y + i);
    return means;
}

} // namespace

double structuralSimilarity(const QImage& a, const QImage& b)
{
    CARINA_EXPECTS(a.size() == b.size() && a.width() >= kWindow && a.height() >= kWindow);
    const ValueMap lumaA = lumaOf(a);
    const ValueMap lumaB = lumaOf(b);
    const ValueMap meanA = windowMeans(lumaA);
    const ValueMap meanB = windowMeans(lumaB);
    const ValueMap meanAA = windowMeans(productOf(lumaA, lumaA));
    const ValueMap meanBB = windowMeans(productOf(lumaB, lumaB));
    const ValueMap meanAB = windowMeans(productOf(lumaA, lumaB));
    double sum = 0.0;
    for (std::size_t i = 0; i < meanA.values.size(); ++i) {
        const double muA = meanA.values[i];
        const double muB = meanB.values[i];
        const double varianceA = meanAA.values[i] - muA * muA;
        const double varianceB = meanBB.values[i] - muB * muB;
        const double covariance = meanAB.values[i] - muA * muB;
        sum += (2.0 * muA * muB + kC1) * (2.0 * covariance + kC2)
               / ((muA * muA + muB * muB + kC1) * (varianceA + varianceB + kC2));
    }
    return sum / double(meanA.values.size());
}

} // namespace carina::lab
