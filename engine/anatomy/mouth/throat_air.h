#pragma once

#include "engine/anatomy/airway/pharynx_place.h"
#include "engine/anatomy/larynx/larynx_frame.h"

namespace carina
{

/// The air of mouth and throat as one cavity, as if no tongue and no palate lay in it: from behind
/// the lips between the cheeks and over the floor of the mouth into the pharynx, up behind the soft
/// palate, and down beside and behind the larynx to the entrance of the oesophagus.
class ThroatAir
{
public:
    ThroatAir(const BodyPlan& plan, const LarynxFrame& larynx);

    /// Frame A, metres; below zero in the air, near its wall about the distance to it.
    [[nodiscard]] double distance(const Vec3& p_A) const;

private:
    PharynxPlace m_place;
    LarynxFrame m_larynx;
    BodyPlan m_plan;
};

/// Half the width of the mouth between the cheeks at a y, and the height of its floor, in reference
/// millimetres (BodyPlan) from the edge of the upper incisors.
[[nodiscard]] double halfMouth_mm(double y_mm);
[[nodiscard]] double floorOfMouth_mm(Posture posture);

} // namespace carina
