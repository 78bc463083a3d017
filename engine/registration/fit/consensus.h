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

/// Which of `count` things agree about one model, though others among them are wrong: random
/// sample consensus (Fischler and Bolles 1981). Each sample of `sampleSize` things gives a model;
/// the best has the least
///
///     sum over all things of min(d^2, limit^2)
///
/// where d is the distance of a thing from the model (Torr and Zisserman 2000). Whenever a model is
/// better than all before, it is fitted anew to all things within the limit of it, as often as this
/// makes it better still (Chum, Matas and Kittler 2003). Samples are drawn until one of things that
/// are right was among them with all but certainty, and no more than half of all need be right.
/// The draws begin alike each time: the same things give the same answer.
///
/// @param fit      fit(indices) gives the model of some things
/// @param distance distance(model, index); one that is no number lies beyond any limit
/// @pre count is at least sampleSize.
/// @returns their indices, ascending; none where no model could be made.
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
