#pragma once

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <vector>

namespace carina
{

/// A system of linear equations for places in a row, of which each has three unknowns and is
/// coupled with the two before and the two behind it: a symmetric matrix of blocks of 3 x 3, solved
/// directly by Cholesky's L L^T. Its cost is in proportion to the number of places.
///
/// It is eliminated from the last place to the first: those of a rod that is held at its first ones
/// leave then no more than what is left is stiff, so that little is lost in differences. No block
/// is inverted: what is much stiffer one way than another would lose that other way by rounding.
class BandedSystem
{
public:
    using Values = Eigen::Vector3d;
    using Block = Eigen::Matrix3d;

    struct Row {
        Block diagonal = Block::Zero();
        Block before = Block::Zero();       ///< with the place before
        Block secondBefore = Block::Zero(); ///< with the one before that
        Values right = Values::Zero();      ///< the right side
    };
    std::vector<Row> rows;

    void resize(std::size_t places)
    {
        rows.resize(places);
        m_factors.resize(places);
    }

    /// Solves it for the rows from `first` on, with the given values of the two places before.
    /// @param values of all places; those from `first` on are found
    /// @returns false where the matrix is not positive definite; they are then undefined.
    /// @pre as many values as rows, set by resize(); first at least 2
    [[nodiscard]] bool solve(std::size_t first, std::vector<Values>& values)
    {
        for (std::size_t i = rows.size(); i-- > first;)
            if (!eliminate(i))
                return false;
        for (std::size_t i = first; i < rows.size(); ++i)
            values[i] = m_factors[i].solved(values[i - 1], values[i - 2]);
        return true;
    }

private:
    /// Of a place when those behind it are eliminated: L of its own block, and what L couples it
    /// with; a column of each is found from the same one of the matrix.
    struct Factor {
        Block own = Block::Zero();          ///< only what is below the diagonal
        Block before = Block::Zero();       ///< rows of the place before
        Block secondBefore = Block::Zero(); ///< rows of the one before that
        Values right = Values::Zero();
        Values perDiagonal = Values::Zero(); ///< of `own`

        /// From the blocks of the matrix. @returns false where that is not positive definite.
        [[nodiscard]] bool factorise()
        {
            for (int k = 0; k < 3; ++k) {
                const double pivot = own(k, k);
                if (!(pivot > 0.0))
                    return false;
                const double per = 1.0 / std::sqrt(pivot);
                perDiagonal[k] = per;
                own.col(k) *= per;
                before.col(k) *= per;
                secondBefore.col(k) *= per;
                right[k] *= per;
                for (int j = k + 1; j < 3; ++j) {
                    const double share = own(j, k);
                    own.col(j) -= share * own.col(k);
                    before.col(j) -= share * before.col(k);
                    secondBefore.col(j) -= share * secondBefore.col(k);
                    right[j] -= share * right[k];
                }
            }
            return true;
        }

        [[nodiscard]] Values solved(const Values& one, const Values& two) const
        {
            Values value = right;
            value.noalias() -= before.transpose() * one;
            value.noalias() -= secondBefore.transpose() * two;
            for (int k = 2; k >= 0; --k) {
                for (int j = k + 1; j < 3; ++j)
                    value[k] -= own(j, k) * value[j];
                value[k] *= perDiagonal[k];
            }
            return value;
        }
    };

    [[nodiscard]] bool eliminate(std::size_t i)
    {
        const Row& row = rows[i];
        Factor& it = m_factors[i];
        it.own = row.diagonal;
        it.before = row.before.transpose();
        it.secondBefore = row.secondBefore.transpose();
        it.right = row.right;
        if (i + 1 < rows.size()) {
            const Factor& next = m_factors[i + 1];
            it.own.noalias() -= next.before * next.before.transpose();
            it.before.noalias() -= next.secondBefore * next.before.transpose();
            it.right.noalias() -= next.before * next.right;
        }
        if (i + 2 < rows.size()) {
            const Factor& second = m_factors[i + 2];
            it.own.noalias() -= second.secondBefore * second.secondBefore.transpose();
            it.right.noalias() -= second.secondBefore * second.right;
        }
        return it.factorise();
    }

    std::vector<Factor> m_factors;
};

} // namespace carina
