#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace carina
{

/// A system of linear equations whose symmetric, positive definite matrix is zero farther than
/// kBand from its diagonal, solved directly: Cholesky's L D L^T within the band.
template <std::size_t kBand> class BandedSystem
{
public:
    /// All zero, of this many unknowns.
    void clear(std::size_t unknowns)
    {
        m_rows.assign(unknowns, Row{});
        right.assign(unknowns, 0.0);
    }

    /// The coefficient at row and column. @pre column <= row <= column + kBand
    double& at(std::size_t row, std::size_t column) { return m_rows[row][kBand + column - row]; }

    std::vector<double> right; ///< the right side; after solve() the unknowns

    /// @returns false where the matrix is not positive definite; the unknowns are then undefined.
    [[nodiscard]] bool solve()
    {
        const std::size_t count = m_rows.size();
        m_perPivot.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            Row& row = m_rows[i];
            const std::size_t first = i > kBand ? i - kBand : 0;
            double pivot = row[kBand];
            double value = right[i];
            for (std::size_t j = first; j < i; ++j) {
                const Row& other = m_rows[j];
                // Of both rows the part in columns first to j - 1; row has l d there.
                double sum = row[kBand + j - i];
                for (std::size_t k = std::max(first, j > kBand ? j - kBand : 0); k < j; ++k)
                    sum -= row[kBand + k - i] * other[kBand + k - j];
                row[kBand + j - i] = sum;
            }
            for (std::size_t j = first; j < i; ++j) {
                const double scaled = row[kBand + j - i];
                const double factor = scaled * m_perPivot[j];
                pivot -= scaled * factor;
                value -= factor * right[j];
                row[kBand + j - i] = factor;
            }
            if (!(pivot > 0.0))
                return false;
            m_perPivot[i] = 1.0 / pivot;
            right[i] = value;
        }
        for (std::size_t i = count; i-- > 0;) {
            double value = right[i] * m_perPivot[i];
            for (std::size_t j = i + 1; j < std::min(count, i + kBand + 1); ++j)
                value -= m_rows[j][kBand + i - j] * right[j];
            right[i] = value;
        }
        return true;
    }

private:
    using Row = std::array<double, kBand + 1>; ///< the diagonal is its last

    std::vector<Row> m_rows;
    std::vector<double> m_perPivot;
};

} // namespace carina
