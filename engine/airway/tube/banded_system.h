#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include <cstddef>
#include <vector>

namespace carina
{

/// A system of linear equations for places in a row, of which each has four unknowns and is coupled
/// with the two before and the two behind it: a symmetric matrix of blocks of 4 x 4, solved
/// directly by L D L^T. Its cost is in proportion to the number of places.
class BandedSystem
{
public:
    using Values = Eigen::Vector4d;
    using Block = Eigen::Matrix4d;

    struct Row {
        Block diagonal = Block::Zero();
        Block before = Block::Zero();       ///< with the place before
        Block secondBefore = Block::Zero(); ///< with the one before that
        Values right = Values::Zero();      ///< the right side
    };
    std::vector<Row> rows;
    /// What is added to a row for another solution; as many as rows.
    struct Support {
        Block diagonal = Block::Zero();
        Values right = Values::Zero();
    };
    std::vector<Support> supports;

    void resize(std::size_t places)
    {
        rows.resize(places);
        supports.resize(places);
        m_factors.resize(places);
    }

    /// Solves it for the rows from `first` on, with the given values of the two places before.
    /// @param values of all places; those from `first` on are found
    /// @returns false where the matrix is not positive definite; they are then undefined.
    /// @pre as many values as rows, set by resize(); first at least 2
    [[nodiscard]] bool solve(std::size_t first, std::vector<Values>& values)
    {
        for (std::size_t i = first; i < rows.size(); ++i)
            if (!eliminate(i, first, values))
                return false;
        for (std::size_t i = rows.size(); i-- > first;) {
            Values value = m_factors[i].inverse * values[i];
            if (i + 1 < rows.size())
                value.noalias() -= m_factors[i + 1].before.transpose() * values[i + 1];
            if (i + 2 < rows.size())
                value.noalias() -= m_factors[i + 2].secondBefore.transpose() * values[i + 2];
            values[i] = value;
        }
        return true;
    }

private:
    struct Factor {
        Block before = Block::Zero(); ///< blocks of L
        Block secondBefore = Block::Zero();
        Block inverse = Block::Zero(); ///< of the block of D
    };

    [[nodiscard]] bool eliminate(std::size_t i, std::size_t first, std::vector<Values>& values)
    {
        const Row& row = rows[i];
        Factor& it = m_factors[i];
        Block pivot = row.diagonal + supports[i].diagonal;
        Values value = row.right + supports[i].right;
        const bool hasSecond = i >= first + 2;
        const bool hasOne = i >= first + 1;
        // Of the places before `first` the values are given; of the others L is known.
        if (hasSecond) {
            it.secondBefore.noalias() = row.secondBefore * m_factors[i - 2].inverse;
            pivot.noalias() -= it.secondBefore * row.secondBefore.transpose();
            value.noalias() -= it.secondBefore * values[i - 2];
        } else {
            value.noalias() -= row.secondBefore * values[i - 2];
        }
        if (hasOne) {
            Block coupled = row.before;
            if (hasSecond)
                coupled.noalias() -= row.secondBefore * m_factors[i - 1].before.transpose();
            it.before.noalias() = coupled * m_factors[i - 1].inverse;
            pivot.noalias() -= it.before * coupled.transpose();
            value.noalias() -= it.before * values[i - 1];
        } else {
            value.noalias() -= row.before * values[i - 1];
        }
        values[i] = value;
        return invert(pivot, it.inverse);
    }

    [[nodiscard]] static bool isPositive(const Eigen::Matrix2d& m)
    {
        return m(0, 0) > 0.0 && m(0, 0) * m(1, 1) - m(1, 0) * m(1, 0) > 0.0;
    }

    /// Of a symmetric matrix by its quarters; false where that is not positive definite.
    [[nodiscard]] static bool invert(const Block& m, Block& inverse)
    {
        const Eigen::Matrix2d a = m.topLeftCorner<2, 2>();
        const Eigen::Matrix2d b = m.bottomLeftCorner<2, 2>();
        if (!isPositive(a))
            return false;
        const Eigen::Matrix2d perA = a.inverse();
        const Eigen::Matrix2d ba = b * perA;
        const Eigen::Matrix2d rest = m.bottomRightCorner<2, 2>() - ba * b.transpose();
        if (!isPositive(rest))
            return false;
        const Eigen::Matrix2d perRest = rest.inverse();
        const Eigen::Matrix2d across = -perRest * ba;
        inverse.topLeftCorner<2, 2>() = perA - ba.transpose() * across;
        inverse.bottomLeftCorner<2, 2>() = across;
        inverse.topRightCorner<2, 2>() = across.transpose();
        inverse.bottomRightCorner<2, 2>() = perRest;
        return true;
    }

    std::vector<Factor> m_factors;
};

} // namespace carina
