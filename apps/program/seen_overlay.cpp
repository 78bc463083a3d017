#include "apps/program/seen_overlay.h"

#include "engine/core/units.h"

#include <algorithm>
#include <numeric>

namespace carina::program
{
namespace
{

constexpr std::array<const char*, 3> kPlaceNames{"carina", "vocal_cords", "incisors"};

QJsonObject describeErrors(std::vector<double> errors_mm)
{
    std::ranges::sort(errors_mm);
    const double sum = std::accumulate(errors_mm.begin(), errors_mm.end(), 0.0);
    const std::size_t rank = (errors_mm.size() * 95 + 99) / 100 - 1; // nearest-rank percentile
    return {{QStringLiteral("mean_mm"), sum / double(errors_mm.size())},
            {QStringLiteral("p95_mm"), errors_mm[rank]},
            {QStringLiteral("largest_mm"), errors_mm.back()}};
}

} // namespace

SeenOverlay::SeenOverlay(TrueView truth, const AirwayLandmarks& airway)
    : m_truth{std::move(truth)}, m_p_A{airway.p_A_carina, airway.p_A_glottis, airway.p_A_incisors}
{
}

void SeenOverlay::add(const RigidTransform& X_AH, SessionTime lit)
{
    const auto X_HA_true = m_truth(lit);
    if (!X_HA_true)
        return;
    const RigidTransform X_HA = X_AH.inverse();
    for (std::size_t i = 0; i < kPlaces; ++i)
        m_errors_mm[i].push_back(
            inMillimetres(metres((X_HA * m_p_A[i] - *X_HA_true * m_p_A[i]).norm())));
}

QJsonObject SeenOverlay::report() const
{
    if (m_errors_mm.front().empty())
        return {};
    QJsonObject report{{QStringLiteral("frames"), qint64(m_errors_mm.front().size())}};
    for (std::size_t i = 0; i < kPlaces; ++i)
        report[QLatin1StringView{kPlaceNames[i]}] = describeErrors(m_errors_mm[i]);
    return report;
}

} // namespace carina::program
