#include "engine/anatomy/airway/centreline.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{

Length lengthOf(std::span<const Vec3> line)
{
    double sum = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i)
        sum += (line[i] - line[i - 1]).norm();
    return metres(sum);
}

Vec3 pointAlong(std::span<const Vec3> line, Length along)
{
    CARINA_EXPECTS(!line.empty());
    double left = std::max(along.si, 0.0);
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vec3 step = line[i] - line[i - 1];
        const double length = step.norm();
        if (left < length)
            return line[i - 1] + left / length * step;
        left -= length;
    }
    return line.back();
}

Centreline evenlySpaced(std::span<const Vec3> line, Length spacing)
{
    CARINA_EXPECTS(line.size() >= 2 && spacing.si > 0.0);
    const Length length = lengthOf(line);
    const auto steps = static_cast<std::size_t>(std::max(std::ceil(length / spacing), 1.0));
    Centreline even;
    even.reserve(steps + 1);
    for (std::size_t i = 0; i < steps; ++i)
        even.push_back(pointAlong(line, (double(i) / double(steps)) * length));
    even.push_back(line.back());
    return even;
}

} // namespace carina
