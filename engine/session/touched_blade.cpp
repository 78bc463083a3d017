#include "engine/session/touched_blade.h"

namespace carina
{

Blade touchedBlade(const BladeShape& shape)
{
    constexpr double kCameraFromTip = 0.31; // of the length, as on a Macintosh 3
    const double reach = -shape.p_L_tip.z();
    return {.name = "as touched",
            .form = {.reach = reach,
                     .rise = shape.p_L_tip.y(),
                     .sag = shape.sag().si,
                     .width = shape.heelWidth.si},
            .lift = shape.isCurved() ? EpiglottisLift::Ligament : EpiglottisLift::Direct,
            .cameraToTip = metres(kCameraFromTip * reach)};
}

} // namespace carina
