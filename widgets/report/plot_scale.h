#pragma once

#include <QString>

#include <vector>

namespace carina
{

/// The scale of one axis of a plot: its range, its ticks, and the mapping of values to positions.
class PlotScale
{
public:
    struct Tick {
        double value = 0.0;
        QString label; ///< empty for a minor one
    };

    /// A linear scale with round ends that covers least and greatest, and 0 if it is nearer than a
    /// quarter of their difference. @pre both are finite
    [[nodiscard]] static PlotScale linear(double least, double greatest);
    /// A logarithmic scale of whole decades that covers both. @pre 0 < least <= greatest
    [[nodiscard]] static PlotScale logarithmic(double least, double greatest);

    [[nodiscard]] double least() const { return m_least; }
    [[nodiscard]] double greatest() const { return m_greatest; }
    /// The position of a number on the axis: 0 at its start, 1 at its end.
    [[nodiscard]] double placeOf(double value) const;
    /// False for numbers that a logarithmic axis cannot show.
    [[nodiscard]] bool shows(double value) const;
    /// Linear: at multiples of 1, 2 or 5 times a power of ten. Logarithmic: at each decade, with
    /// minor ticks between if there are few decades.
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
