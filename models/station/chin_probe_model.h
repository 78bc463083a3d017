#pragma once

#include "engine/session/station_tracking.h"
#include "models/registration/registration_guard.h"

#include <QString>

#include <memory>

namespace carina
{

/// By what a station knows where its patient is, in words; and what the motion of its chin probe is
/// taken for, as a person chooses it.
class ChinProbeModel
{
public:
    using Guard = std::unique_ptr<RegistrationGuard>;

    /// @param tracking outlives this; null for a program that only watches
    /// @param guard    of the registration, as its owner has it now; outlives this, null for none
    explicit ChinProbeModel(StationTracking* tracking, const Guard* guard = nullptr)
        : m_tracking{tracking}, m_guard{guard}
    {
    }

    /// Whether there is anything to choose: a body probe leaves nothing to assume.
    [[nodiscard]] bool isThere() const
    {
        return m_tracking && m_tracking->hasChinProbe() && !m_tracking->hasBodyProbe();
    }

    /// The manikin is moved with its mouth closed; else it lies still and its jaw opens.
    [[nodiscard]] bool movesManikin() const
    {
        return isThere() && m_tracking->chinMotion() == ChinMotion::OfManikin;
    }
    void setMovesManikin(bool moves) const
    {
        if (isThere())
            m_tracking->takeChinMotion(moves ? ChinMotion::OfManikin : ChinMotion::OfJaw);
    }

    /// The assumption in force, as a translated sentence; empty for a program that only watches.
    [[nodiscard]] QString assumption() const;

    /// What has to be known all the time: that the registration has drifted, or which probe the
    /// patient follows; else empty.
    [[nodiscard]] QString notice() const;

private:
    [[nodiscard]] QString followed() const;

    StationTracking* m_tracking;
    const Guard* m_guard;
};

} // namespace carina
