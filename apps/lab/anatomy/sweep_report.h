#pragma once

#include "evaluation/anatomy/deformation_sweep.h"

#include <QJsonArray>
#include <QJsonObject>

#include <map>
#include <string>

namespace carina::lab
{

/// What a sweep found, combination by combination.
class SweepReport
{
public:
    void add(const DeformationCombination& combination, const std::vector<DeformedPart>& parts);

    /// Whether no surface intersects itself, and nothing is folded.
    [[nodiscard]] bool isAcceptable() const { return m_bad.isEmpty(); }
    /// The keys of `anatomy sweep` from "combinations" to "bad", and "acceptable".
    [[nodiscard]] QJsonObject object() const;

private:
    struct Found {
        qint64 selfIntersecting = 0; ///< combinations
        double leastDeterminant = 1.0;
    };

    qint64 m_combinations = 0;
    qint64 m_selfIntersecting = 0;
    qint64 m_folded = 0;
    std::map<std::string, Found> m_parts;
    double m_least = 1.0;
    QJsonObject m_leastObject;
    QJsonArray m_bad;
};

} // namespace carina::lab
