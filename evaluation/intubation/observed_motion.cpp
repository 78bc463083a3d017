#include "evaluation/intubation/observed_motion.h"

#include "engine/core/expects.h"
#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

// Of each four losses one is a burst of kShortBurst to kLongBurst exposures.
constexpr double kBursts = 0.25;
constexpr int kShortBurst = 5;
constexpr int kLongBurst = 25;
constexpr double kMeanLoss = (1.0 - kBursts) + kBursts * 0.5 * (kShortBurst + kLongBurst);

/// A vector of normal components whose length has this root mean square.
Vec3 normalVector(double rms, std::mt19937& random)
{
    Vec3 v;
    for (double& component : v)
        component = rms / std::sqrt(3.0) * normalOf(random);
    return v;
}

RigidTransform drawnMotion(Length shift, Angle turn, std::mt19937& random)
{
    const Quat q = rotationFromVector(normalVector(turn.si, random));
    return {q, normalVector(shift.si, random)};
}

/// One tool before a tracker.
class WatchedTool
{
public:
    explicit WatchedTool(const ObservationSettings& settings) : m_settings{settings} {}

    void see(const RigidTransform& X_FO, SessionTime t, std::mt19937& random)
    {
        const RigidTransform noise =
            drawnMotion(m_settings.noise, m_settings.rotationNoise, random);
        if (isLost(random)) {
            if (!m_samples.empty())
                m_samples.push_back(
                    {.time = t, .X_FO = m_samples.back().X_FO, .validity = Validity::Lost});
            return;
        }
        m_samples.push_back(
            {.time = t,
             .X_FO = {X_FO.rotation() * noise.rotation(), X_FO.translation() + noise.translation()},
             .error = m_settings.noise.si});
    }
    [[nodiscard]] std::vector<PoseSample> samples() && { return std::move(m_samples); }

private:
    /// A loss begins in so many of the exposures between two that `dropouts` of all are lost.
    bool isLost(std::mt19937& random)
    {
        if (m_left == 0) {
            const double begins = m_settings.dropouts / ((1.0 - m_settings.dropouts) * kMeanLoss);
            if (evenOf(random) < begins)
                m_left =
                    evenOf(random) < kBursts
                        ? kShortBurst
                              + static_cast<int>(evenOf(random) * (kLongBurst - kShortBurst + 1))
                        : 1;
        }
        if (m_left == 0)
            return false;
        --m_left;
        return true;
    }

    ObservationSettings m_settings;
    std::vector<PoseSample> m_samples;
    int m_left = 0; ///< exposures of the present loss
};

} // namespace

ObservedMotion observed(const IntubationMotion& motion, const ObservationSettings& settings,
                        SessionTime start, std::mt19937& random)
{
    CARINA_EXPECTS(settings.rate > hertz(0.0) && settings.dropouts >= 0.0
                   && settings.dropouts < 1.0);
    ObservedMotion seen;
    seen.X_AprimeA = drawnMotion(settings.registration, settings.registrationTurn, random);
    WatchedTool tube{settings};
    WatchedTool laryngoscope{settings};
    WatchedTool jaw{settings};
    const double mostJitter = 0.4 / settings.rate.si; // samples stay in their order
    for (int i = 0;; ++i) {
        const double late = toSeconds(settings.jitter) * normalOf(random);
        const Duration t = fromSeconds(
            std::max(i / settings.rate.si + std::clamp(late, -mostJitter, mostJitter), 0.0));
        if (t > motion.length())
            break;
        const MotionMoment moment = motion.at(t);
        tube.see(seen.X_AprimeA * moment.X_AE, start + t, random);
        laryngoscope.see(seen.X_AprimeA * moment.X_AL, start + t, random);
        jaw.see(moment.X_AJ, start + t, random);
    }
    seen.tube = std::move(tube).samples();
    seen.laryngoscope = std::move(laryngoscope).samples();
    seen.jaw = std::move(jaw).samples();
    return seen;
}

} // namespace carina
