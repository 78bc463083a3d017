#include "engine/airway/tube/elastic_tube.h"

#include "engine/anatomy/airway/centreline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

static_assert(ElasticTube::kStep == std::chrono::milliseconds{10} && kTubeStep == 0.01);

SessionTime stepUntil(SessionTime t)
{
    return SessionTime{t.time_since_epoch() / ElasticTube::kStep * ElasticTube::kStep};
}

std::vector<Vec3> taken(std::span<const Vec3> line, const RigidTransform& X)
{
    std::vector<Vec3> moved;
    moved.reserve(line.size());
    for (const Vec3& p : line)
        moved.push_back(X * p);
    return moved;
}

} // namespace

TissueAround tissueAround(const AirwayField& changes, const FollowingThroat& throat,
                          const BladeField& blade)
{
    return {tissueMotion(changes, throat), bladePushing(blade), throat.neck};
}

TubeSize sizeOf(const TubeShape& shape)
{
    const std::vector<Length> sizes = tubeSizes();
    const Length inner = *std::ranges::min_element(sizes, {}, [&](Length size) {
        return std::abs((outerDiameterOf(size) - shape.outerDiameter).si);
    });
    TubeSize size = tubeOfSize(inner).value();
    size.outer = shape.outerDiameter;
    size.length = lengthOf(shape.p_E_centre);
    return size;
}

ElasticTube::ElasticTube(const TubeShape& shape, std::shared_ptr<const AirwayLumen> lumen)
    : m_lumen{std::move(lumen)},
      m_shape{shape},
      m_begun{sizeOf(shape), shape.p_E_centre},
      m_tube{m_begun}
{
}

void ElasticTube::follow(SessionTime until, const ConnectorAt& connectorAt,
                         const TissueAround& tissue)
{
    const SessionTime last = stepUntil(until);
    const SessionTime next = m_stepped ? *m_stepped + kStep : last;
    if (next > last)
        return;
    m_stepped = last;
    const MovedLumen lumen = moved(*m_lumen, tissue.motion, tissue.push);
    const std::vector<Vec3> p_E_rest = centreIn(tissue.neck, m_shape);
    for (SessionTime t = std::max(next, last - (kMostSteps - 1) * kStep); t <= last; t += kStep) {
        const auto X_AE = connectorAt(t);
        if (!X_AE)
            continue;
        m_tube.step(*X_AE, lumen, p_E_rest);
        m_laid = t;
    }
}

bool ElasticTube::layAnew(SessionTime t, const Vec3& p_E_tip, bool isHeldUp,
                          const ConnectorAt& connectorAt, const TissueAround& tissue)
{
    const SessionTime at = stepUntil(t);
    const auto X_AE = connectorAt(at);
    const auto X_AE_tip = connectorAt(t);
    if (!X_AE || !X_AE_tip)
        return false;
    m_tube = m_begun;
    m_tube.found(*X_AE, *X_AE_tip * p_E_tip, isHeldUp, moved(*m_lumen, tissue.motion, tissue.push),
                 centreIn(tissue.neck, m_shape));
    m_laid = m_stepped = at;
    return true;
}

void ElasticTube::letGo()
{
    if (!m_stepped)
        return;
    m_tube = m_begun;
    m_laid.reset();
    m_stepped.reset();
}

bool ElasticTube::isStoppedAtCords() const
{
    const TubeTip& tip = m_tube.tip();
    return isLaid() && tip.isStopped && tip.way == AirwayWay::Trunk && tip.pastGlottis <= kAtCords;
}

std::vector<Vec3> ElasticTube::ahead(SessionTime t, const RigidTransform& X_AE,
                                     const ConnectorAt& connectorAt,
                                     const TissueAround& tissue) const
{
    const MovedLumen lumen = moved(*m_lumen, tissue.motion, tissue.push);
    const std::vector<Vec3> p_E_rest = centreIn(tissue.neck, m_shape);
    TubeInLumen there = m_tube;
    const SessionTime first = stepUntil(t) - (kMostStepsAhead - 2) * kStep;
    for (SessionTime next = std::max(*m_laid + kStep, first); next < t; next += kStep)
        if (const auto X = connectorAt(next))
            there.step(*X, lumen, p_E_rest);
    there.step(X_AE, lumen, p_E_rest);
    return taken(there.constrained(), X_AE.inverse());
}

} // namespace carina
