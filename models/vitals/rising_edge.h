#pragma once

namespace carina
{

/// Finds where a curve rises: through a high level, after it was below a low one.
class RisingEdge
{
public:
    /// @pre low is not above high
    constexpr RisingEdge(double low, double high) : m_low{low}, m_high{high} {}

    /// @returns whether it rises with this value
    bool take(double value)
    {
        if (value < m_low)
            m_isLow = true;
        const bool rises = m_isLow && value >= m_high;
        m_isLow = m_isLow && !rises;
        return rises;
    }

private:
    double m_low;
    double m_high;
    bool m_isLow = false;
};

} // namespace carina
