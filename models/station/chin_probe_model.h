#pragma once

#include "engine/session/station_tracking.h"

#include <QString>

namespace carina
{

/// Describes in words which probe gives the pose of a station's patient, and lets a person choose
/// how motion of the chin probe is interpreted: as jaw opening or as motion of the manikin.
class ChinProbeModel
{
public:
    /// @param tracking outlives this; null for a program without a tracker
    explicit ChinProbeModel(StationTracking* tracking) : m_tracking{tracking} {}

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

    /// What keeps the tracker from tracking, as a translated sentence; empty where nothing does.
    [[nodiscard]] QString trackerTrouble() const;

    /// A permanent notice: which probe the patient follows; empty where it follows none.
    [[nodiscard]] QString notice() const;

private:
    StationTracking* m_tracking;
};

} // namespace carina
