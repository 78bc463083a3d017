#include "engine/airway/monitor/drawn_ways.h"

namespace carina
{
namespace
{

/// Below it, in an adult, what lies around the airway is trachea and no larynx: the cricoid. Of
/// ours.
constexpr Length kCordsToTrachea = millimetres(25.0);

/// As the larynx, which a blade tilts; what is above it less and less, as the pharynx, and the
/// palate and the teeth not at all.
Vec3 tilted(const BladeFrame<double>& blade, const Vec3& p_A)
{
    const double height = blade.up.dot(p_A) + blade.upFrom;
    const double lean = formula::leaning(height).value;
    const double share = lean > 0.0 ? formula::leaningOfPharynx(height).value / lean : 0.0;
    return p_A + share * larynxTilt<double>(blade, p_A).d;
}

} // namespace

PatientWays drawnWays(const PatientWays& ways, const AirwayField& changes,
                      const FollowingThroat& throat, const BladeField& tissue)
{
    const Vec3 up = ways.up_A();
    const Vec3 p_A_glottis = ways.p_A_glottis();
    const double larynx = ways.size * kCordsToTrachea.si;
    return moved(ways, [&](const Vec3& place) {
        const bool isTrachea = up.dot(p_A_glottis - place) > larynx;
        Vec3 p_A = place;
        p_A += airwayPull<double>(changes.frame(),
                                  isTrachea ? AirwayTissue::Windpipe : AirwayTissue::Larynx, p_A)
                   .d;
        p_A = throat.neck.placed(p_A);
        p_A += shareOfJaw(ways, place) * throatPull(throat, ThroatTissue::Airway, p_A).d;
        return tilted(tissue.frame(), p_A);
    });
}

} // namespace carina
