#include "evaluation/drift/shown_actions.h"

#include "engine/geometry/rotation.h"

namespace carina
{
namespace
{

/// Cosine of the largest angle between the axis of an action and that about which a picture turns:
/// snapshots are rounded, and the rate of a display is not that of the samples.
constexpr double kSameAxis = 0.9;

} // namespace

void ShownActions::endAction(const Quat& q_AO, const Vec3& axis_A)
{
    const Vec3 turned_A = rotationVector(q_AO * m_before.conjugate());
    const bool isShown = turned_A.dot(axis_A) > kSameAxis * turned_A.norm();
    if (!isShown)
        ++m_lost;
    if (isShown && m_wasShown) {
        m_shownAngles += m_angles;
        m_shownSamples += m_samples;
    }
    m_wasShown = isShown;
    m_angles = 0.0;
    m_samples = 0;
}

std::optional<double> meanShown(std::span<const ShownActions> viewers)
{
    double angles = 0.0;
    int samples = 0;
    for (const ShownActions& viewer : viewers) {
        angles += viewer.m_shownAngles;
        samples += viewer.m_shownSamples;
    }
    return samples > 0 ? std::optional{angles / samples} : std::nullopt;
}

} // namespace carina
