#pragma once

#include <QString>

#include <vector>

namespace carina
{

/// One axis of a plot: which numbers it shows, and where.
class PlotScale
{
public:
    struct Tick {
        double value = 0.0;
        QString label; ///< empty for a minor one
    };

    /// Round ends around least and greatest, and around 0 where it is less than a quarter of their
    /// distance away. @pre both are finite
    [[nodiscard]] static PlotScale linear(double least, double greatest);
    /// Whole decades around both. @pre 0 < least <= greatest
    [[nodiscard]] static PlotScale logarithmic(double least, double greatest);

    [[nodiscard]] double least() const { return m_least; }
    [[nodiscard]] double greatest() const { return m_greatest; }
    /// Where a number lies on the axis: 0 at its beginning, 1 at its end.
    [[nodiscard]] double placeOf(double value) const;
    /// False for what a logarithmic axis cannot show.
    [[nodiscard]] bool shows(double value) const;
    /// Linear: at multiples of 1, 2 or 5 times a power of ten. Logarithmic: a decade each, and
    /// minor ones between where there are few decades.
    [[nodiscard]] std::vector<Tick> ticks() const;

private:
    PlotScale(double least, double greatest, double step)
        : m_least{least}, m_greatest{greatest}, m_step{step}
    {
    }
    [[nodiscard]] std::vector<Tick> decades() const;

    double m_least;
    double m_greatest;
    double m_step; // 0 for a logarithmic axis
};

} // namespace carina
