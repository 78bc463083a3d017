#include "apps/lab/attack/attackers/false_samples.h"

#include "engine/sync/connection/sync_host.h"

#include <chrono>
#include <limits>

namespace carina::lab
{
namespace
{

constexpr double kSamePlace = 1e-3; ///< metres: a place is rounded on its way
/// An intruder returns no times, so that to the host its path has no length, and adds nothing to
/// what a sample may be ahead. A millisecond is for the rounding of times.
constexpr Duration kMostAhead = SyncHost::kLargestAhead + std::chrono::milliseconds{1};

} // namespace

StreamCpo FalseSamples::sample(ObjectId object, std::uint16_t sequence, SessionTime time)
{
    StreamCpo sample;
    sample.object = object;
    sample.sequence = sequence;
    sample.time = time;
    sample.X_AO = RigidTransform::translation(place());
    return sample;
}

void FalseSamples::see(const StreamGroup& group, std::optional<ObjectId> own, SessionTime hostSent)
{
    for (const StreamCpo& each : group.streams) {
        if ((each.X_AO.translation() - place()).norm() > kSamePlace)
            continue;
        if (each.time > hostSent + kMostAhead)
            ++m_ahead;
        if (each.object != own)
            ++m_foreign;
        else if (each.time <= hostSent + kMostAhead)
            ++m_own;
    }
}

std::vector<Measured> FalseSamples::measured(Duration length) const
{
    return {{"samples of the false tube that an observer was sent in the place of another's object",
             double(m_foreign), 0.0, 0.0},
            {"samples of it from ahead of the session that the observer was sent", double(m_ahead),
             0.0, 0.0},
            {"samples of it in time, as its own object, in a second that the observer was sent",
             double(m_own) / toSeconds(length), 1.0, std::numeric_limits<double>::infinity()}};
}

} // namespace carina::lab
