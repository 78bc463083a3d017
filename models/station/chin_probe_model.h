#pragma once

#include "engine/session/station_tracking.h"
#include "models/registration/registration_guard.h"

#include <QString>

#include <memory>

namespace carina
{

/// Describes in words which probe gives the pose of a station's patient, and lets a person choose
/// how motion of the chin probe is interpreted: as jaw opening or as motion of the manikin.
class ChinProbeModel
{
public:
    using Guard = std::unique_ptr<RegistrationGuard>;

    /// @param tracking outlives this; null for a program without a tracker
    /// @param guard    pointer to the owner's present guard of the registration; outlives this;
    ///                 null for none
    explicit ChinProbeModel(StationTracking* tracking, const Guard* guard = nullptr)
        : m_tracking{tracking}, m_guard{guard}
    {
    }

    /// Whether there is a choice: with a body probe no assumption is needed.
    [[nodiscard]] bool isThere() const
    {
        return m_tracking && m_tracking->hasChinProbe() && !m_tracking->hasBodyProbe();
    }

    /// True: the manikin is moved with its mouth closed; false: it lies still and its jaw opens.
    [[nodiscard]] bool movesManikin() const
    {
        return isThere() && m_tracking->chinMotion() == ChinMotion::OfManikin;
    }
    void setMovesManikin(bool moves) const
    {
        if (isThere())
            m_tracking->takeChinMotion(moves ? ChinMotion::OfManikin : ChinMotion::OfJaw);
    }

    /// The assumption in force, as a translated sentence; empty for a program without a tracker.
    [[nodiscard]] QString assumption() const;

    /// A permanent notice: that the registration has drifted, or which probe the patient follows;
    /// else empty.
    [[nodiscard]] QString notice() const;

private:
    [[nodiscard]] QString followed() const;

    StationTracking* m_tracking;
    const Guard* m_guard;
};

} // namespace carina
