#include "engine/session/respiration/tube_breath_watch.h"

#include "engine/lungs/mechanics/tube_place.h"

#include <utility>

namespace carina
{
namespace
{

bool isDelivering(const PatientRun& run)
{
    return run.fold().isVentilated() || run.body().settings().stomachBreaths.si > 0.0;
}

} // namespace

std::optional<SessionTime> TubeBreathWatch::take(const PatientRun& run, TubeSeat seat)
{
    const TubeSeat before = std::exchange(m_seat, seat);
    const bool isAnotherWay =
        seat == TubeSeat::None || isThroughCords(seat) != isThroughCords(before);
    if (isAnotherWay)
        m_isFound = false;
    const bool isThere = seat != TubeSeat::None && run.body().settings().tube.seat == seat;
    if (isAnotherWay || !isThere || !isDelivering(run))
        m_since = run.at();
    const std::optional<SessionTime> began = run.deliveredBreath();
    if (m_isFound || !isThere || !began || *began < m_since)
        return std::nullopt;
    m_isFound = true;
    return began;
}

} // namespace carina
