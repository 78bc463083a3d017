#include "engine/lungs/mechanics/body_position.h"

namespace carina
{
namespace
{

// Of a patient of 2.31 L.
constexpr double kMoreSitting = 0.806 / 2.31;
constexpr double kMoreProne = 0.350 / 2.31;
constexpr double kMoreOfUpperLung = 0.25;
/// Of the muscles' pressure, more on the lower side and less on the upper; chosen so that each lung
/// takes its published share of a breath.
constexpr double kDriveAside = 0.4;

/// What a position makes of a healthy patient, right and left.
struct Posture {
    std::array<double, 2> more{}; ///< of the resting volume
    std::array<double, 2> drive{1.0, 1.0};
    double sag = 0.0;
};

Posture onSide(std::size_t lower)
{
    Posture posture{.sag = -0.5};
    posture.more[1 - lower] = kMoreOfUpperLung;
    posture.drive[lower] = 1.0 + kDriveAside;
    posture.drive[1 - lower] = 1.0 - kDriveAside;
    return posture;
}

Posture postureOf(BodyPosition position)
{
    switch (position) {
    case BodyPosition::Supine:
        break;
    case BodyPosition::Sitting:
        return {.more = {kMoreSitting, kMoreSitting}, .sag = -0.5};
    case BodyPosition::Prone:
        return {.more = {kMoreProne, kMoreProne}, .sag = -1.0};
    case BodyPosition::RightLateral:
        return onSide(0);
    case BodyPosition::LeftLateral:
        return onSide(1);
    }
    return {};
}

} // namespace

void place(RespiratorySystem& system, BodyPosition position, const RespiratorySystem& onBack)
{
    if (position == BodyPosition::Supine)
        return;
    const Posture posture = postureOf(position);
    std::array<Pressure, 2> recoil; // of a healthy lung as it rests
    for (std::size_t i = 0; i < 2; ++i) {
        const LungMechanics& lung = onBack.lungs[i];
        const Volume more = posture.more[i] * lung.wallVolume;
        recoil[i] = lung.curve.pressureAt(lung.wallVolume + more);
        const Pressure pull = recoil[i] - lung.wallRecoil + Pressure{more.si / lung.wall.si};
        system.lungs[i].wallRecoil = system.lungs[i].wallRecoil + pull;
        system.lungs[i].drive = posture.drive[i];
    }
    system.mediastinalWeight = recoil[0] - recoil[1];
    system.sag = posture.sag;
}

} // namespace carina
