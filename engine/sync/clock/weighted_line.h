#pragma once

#include <vector>

namespace carina
{

/// A line through weighted points whose slope is regularised towards 0 (ridge regression).
///
/// With W the sum of the weights w, x_m and y_m the weighted means, S = sum w (x - x_m)^2, and v
/// the variance of a point of weight 1, from the scatter about the unregularised line:
///
///     slope = sum w (x - x_m)(y - y_m) / (S + v / prior^2)
///
/// which is the most probable slope for slopes distributed about 0 with standard deviation `prior`.
class WeightedLine
{
public:
    struct Point {
        double x = 0.0;
        double y = 0.0;
        double weight = 1.0; ///< above 0
    };
    struct Fit {
        double atZero = 0.0; ///< y at x = 0
        double slope = 0.0;
        double error = 0.0; ///< standard error of atZero
    };

    void add(const Point& point) { m_points.push_back(point); }

    /// @param prior standard deviation of the slope
    /// @pre at least one point
    [[nodiscard]] Fit fit(double prior) const;

private:
    std::vector<Point> m_points;
};

} // namespace carina
