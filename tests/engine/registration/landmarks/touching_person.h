#pragma once

#include "engine/registration/landmarks/touch_recognition.h"
#include "tests/engine/geometry/fit/registration_trials.h"
#include "tests/engine/registration/landmarks/catalogue_places.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace carina::test
{

inline constexpr std::size_t kCount = 8;
inline const Length kFle = millimetres(2.0);
inline const double kNoise = kFle.si / std::sqrt(3.0); // along each axis

using Touches = std::vector<std::optional<Vec3>>;

inline std::vector<std::size_t> shuffled(std::mt19937_64& random)
{
    std::vector<std::size_t> order(kCount);
    std::iota(order.begin(), order.end(), 0U);
    for (std::size_t i = kCount - 1; i > 0; --i)
        std::swap(order[i], order[random() % (i + 1)]);
    return order;
}

/// Somebody who touches the eight landmarks of a manikin, and says which it was when asked.
struct Person {
    explicit Person(unsigned seed) : hand{seed} {}

    void begin()
    {
        X_TA = hand.pose();
        touches.assign(kCount, std::nullopt);
        truth.clear();
    }
    Vec3 touch(std::size_t landmark) { return X_TA * (p_A[landmark] + noise * hand.unit()); }

    TouchFinding recognise(std::size_t landmark, std::optional<std::size_t> proposed)
    {
        const Vec3 p_TQ = touch(landmark);
        truth.emplace_back(landmark, p_TQ);
        return *recogniseTouch({p_A, touches}, p_TQ, kFle, proposed);
    }
    void take(std::size_t landmark) { touches[landmark] = touch(landmark); }
    [[nodiscard]] std::optional<std::size_t> firstOpen() const
    {
        for (std::size_t i = 0; i < kCount; ++i) {
            if (!touches[i])
                return i;
        }
        return std::nullopt;
    }
    /// Whether no touch stands at another's landmark.
    [[nodiscard]] bool isRight() const
    {
        return std::ranges::all_of(truth, [&](const auto& touch) {
            const auto named = std::ranges::find(touches, std::optional{touch.second});
            return named == touches.end() || named - touches.begin() == int(touch.first);
        });
    }

    Hand hand;
    double noise = kNoise;
    std::vector<Vec3> p_A = eightOfTheCatalogue();
    RigidTransform X_TA;
    Touches touches;
    std::vector<std::pair<std::size_t, Vec3>> truth;
};

} // namespace carina::test
