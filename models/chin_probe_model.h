#pragma once

#include "engine/session/station_tracking.h"

namespace carina
{

/// What the motion of a station's chin probe is taken for, as a person chooses it.
class ChinProbeModel
{
public:
    /// @param tracking outlives this; null for a program that only watches
    explicit ChinProbeModel(StationTracking* tracking) : m_tracking{tracking} {}

    /// Whether there is anything to choose.
    [[nodiscard]] bool isThere() const { return m_tracking && m_tracking->hasChinProbe(); }

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

private:
    StationTracking* m_tracking;
};

} // namespace carina
