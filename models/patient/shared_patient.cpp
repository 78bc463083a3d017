#include "models/patient/shared_patient.h"

#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr double kLastDigit = 0.05; ///< what one decimal does not show

} // namespace

const SharedObject* sharedPatient(const SessionState& state, StationId station)
{
    const auto found = std::ranges::find_if(state.objects(), [station](const auto& entry) {
        return entry.second.station == station && entry.second.kind == ObjectKind::Patient;
    });
    return found == state.objects().end() ? nullptr : &found->second;
}

void sharePatient(SessionNode& node, StationId station, const std::string& name)
{
    if (!sharedPatient(*node.state(), station))
        node.propose(station, fact::ObjectShared{{}, node.self(), ObjectKind::Patient, name});
}

Displacement displacementOf(const ActedPose& acted)
{
    return {inDegrees(angleBetween(Quat::Identity(), acted.X_AO.rotation())),
            inMillimetres(metres(acted.X_AO.translation().norm())), 100.0 * acted.scale};
}

bool isInItsPlace(const ActedPose& acted)
{
    const Displacement displacement = displacementOf(acted);
    return displacement.turned_deg < kLastDigit && displacement.moved_mm < kLastDigit
           && std::abs(displacement.size_percent - 100.0) < kLastDigit;
}

} // namespace carina
