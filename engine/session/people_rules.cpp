#include "engine/session/people_rules.h"

#include <string>

namespace carina
{
namespace
{

Result<void> unknown(ParticipantId id)
{
    return fail(Errc::OutOfRange, "participant " + std::to_string(id.value));
}

/// Compare and set, as for the ownership of an object.
Result<void> checkWork(const SessionState& state, StationId id, const fact::WorkTaken& taken)
{
    const auto station = state.stations().find(id);
    if (station == state.stations().end())
        return fail(Errc::OutOfRange, "station " + std::to_string(id.value) + " (does not exist)");
    const auto worker = state.participants().find(taken.participant);
    if (worker == state.participants().end() || !worker->second.present
        || worker->second.station != id)
        return unknown(taken.participant);
    if (worker->second.role == Role::Observer)
        return fail(Errc::NotPermitted, worker->second.name);
    if (state.atWork(id) != taken.before)
        return fail(Errc::OwnerChanged, station->second.name);
    return {};
}

} // namespace

Result<void> checkPeople(const SessionState& state, StationId station, const FactBody& body)
{
    if (const auto* taken = std::get_if<fact::WorkTaken>(&body))
        return checkWork(state, station, *taken);
    const auto* chosen = std::get_if<fact::PlaceChosen>(&body);
    if (chosen && !state.participants().contains(chosen->participant))
        return unknown(chosen->participant);
    return {};
}

bool mayPassOnWork(const SessionState& state, const Participant& author, StationId station,
                   const fact::WorkTaken& taken)
{
    if (author.role != Role::Trainee || author.station != station)
        return false;
    const ParticipantId atWork = state.atWork(station);
    return atWork == author.id || (atWork == kNobody && taken.participant == author.id);
}

} // namespace carina
