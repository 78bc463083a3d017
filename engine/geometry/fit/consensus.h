#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <span>
#include <vector>

namespace carina
{

/// Finds the inliers among `count` items by random sample consensus (RANSAC, Fischler and Bolles
/// 1981). A model is fitted to each random sample of `sampleSize` items; the best model has the
/// smallest
///
///     sum over all items of min(d^2, limit^2)
///
/// where d is the distance of an item from the model (MSAC, Torr and Zisserman 2000). Whenever a
/// model is better than all before, it is refitted to all its inliers (d <= limit) as long as this
/// lessens the sum (LO-RANSAC, Chum, Matas and Kittler 2003). Sampling stops when, for the share of
/// inliers found, a sample of inliers only has been drawn with probability 1 - 1e-9, or after 400
/// draws, which suffice for samples of four where half of all items are inliers. The random numbers
/// have a fixed seed: the same input gives the same result.
///
/// @param limit    largest distance of an inlier from the model
/// @param fit      fit(indices) returns the model of the items with these indices
/// @param distance distance(model, index); NaN counts as an outlier
/// @pre count is at least sampleSize.
/// @returns the indices of the inliers, ascending; empty where no model has sampleSize inliers.
template <class Fit, class Distance>
[[nodiscard]] std::vector<std::size_t> consensus(std::size_t count, std::size_t sampleSize,
                                                 double limit, const Fit& fit,
                                                 const Distance& distance)
{
    constexpr int kFewestDraws = 10;
    constexpr int kMostDraws = 400; // half of all right, samples of four
    constexpr double kMissed = 1e-9;

    double best = std::numeric_limits<double>::infinity();
    std::vector<std::size_t> agreeing;
    const auto isBetter = [&](const auto& model) {
        double cost = 0.0;
        std::vector<std::size_t> within;
        for (std::size_t i = 0; i < count; ++i) {
            const double d = distance(model, i);
            if (d <= limit)
                within.push_back(i);
            cost += d <= limit ? d * d : limit * limit;
        }
        if (within.size() < sampleSize || cost >= best)
            return false;
        best = cost;
        agreeing = std::move(within);
        return true;
    };
    std::mt19937 random{5489U};
    double draws = kMostDraws;
    for (int draw = 0; draw < kFewestDraws || draw < draws; ++draw) {
        std::vector<std::size_t> sample;
        while (sample.size() < sampleSize) {
            const std::size_t index = random() % count;
            if (std::ranges::find(sample, index) == sample.end())
                sample.push_back(index);
        }
        if (!isBetter(fit(sample)))
            continue;
        while (isBetter(fit(agreeing))) {}
        const double share = double(agreeing.size()) / double(count);
        const double allRight = std::pow(share, double(sampleSize));
        draws = std::min(draws, std::log(kMissed) / std::log1p(-allRight));
    }
    return agreeing;
}

} // namespace carina
