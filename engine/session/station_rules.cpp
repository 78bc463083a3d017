#include "engine/session/station_rules.h"

#include "engine/session/conduct_rules.h"
#include "engine/session/facts/plain_name.h"
#include "engine/session/participant_limits.h"

#include <algorithm>

namespace carina
{
namespace
{

template <class... Facts> bool isAnyOf(const FactBody& body)
{
    return (std::holds_alternative<Facts>(body) || ...);
}

/// What may be decided for the patients of all stations at once.
bool changesPatient(const FactBody& body)
{
    return isAnyOf<fact::AnatomyChosen, fact::BreathingRateSet, fact::TidalVolumeSet,
                   fact::InspiratoryFractionSet, fact::PatientBuildSet, fact::LungConditionsSet,
                   fact::VentilatorSet, fact::TubePlaced, fact::BodyPositionSet,
                   fact::BreathingStopped, fact::BagSqueezed, fact::AirwayEventsSet,
                   fact::HeadPositionSet, fact::GasSupplySet, fact::DrugGiven, fact::CuffSet,
                   fact::TubeObstructed>(body);
}

bool isOfNoStation(const FactBody& body)
{
    return isAnyOf<fact::SessionCreated, fact::PhaseChanged, fact::ParticipantLeft,
                   fact::ParticipantFellSilent, fact::StrategyChosen, fact::RegistrationStated>(
               body)
           || isAboutConduct(body);
}

std::size_t numberOpen(const SessionState& state)
{
    return std::size_t(std::ranges::count_if(
        state.stations(), [](const auto& entry) { return !entry.second.closed; }));
}

std::string listed(std::string list, const std::string& name)
{
    return list.empty() ? name : std::move(list) + ", " + name;
}

Result<void> checkStationName(const SessionState& state, StationId self, const std::string& name)
{
    for (const auto& [id, station] : state.stations())
        if (id != self && !station.closed && lookAlike(station.name, name))
            return fail(Errc::NameUnclear, station.name);
    return checkName(name);
}

Result<void> checkClosing(const SessionState& state, StationId station)
{
    std::string there;
    for (const auto& [id, participant] : state.participants())
        if (participant.present && participant.station == station)
            there = listed(std::move(there), participant.name);
    if (!there.empty())
        return fail(Errc::StationOccupied, there);
    if (numberOpen(state) == 1)
        return fail(Errc::StationCount, state.stations().at(station).name);
    return {};
}

} // namespace

std::optional<StationId> openStationNamed(const SessionState& state, std::string_view name)
{
    for (const auto& [id, station] : state.stations())
        if (!station.closed && lookAlike(station.name, name))
            return id;
    return std::nullopt;
}

StationId firstOpenStation(const SessionState& state)
{
    for (const auto& [id, station] : state.stations())
        if (!station.closed)
            return id;
    return kNoStation;
}

std::string openStationNames(const SessionState& state)
{
    std::string names;
    for (const auto& [id, station] : state.stations())
        if (!station.closed)
            names = listed(std::move(names), station.name);
    return names;
}

Result<StationId> settledStation(const SessionState& state, StationId asked, const FactBody& body)
{
    if (std::holds_alternative<fact::StationAdded>(body)) {
        if (asked != kNoStation)
            return fail(Errc::OutOfRange, "a station with a number of its own");
        const auto& all = state.stations();
        return all.empty() ? StationId{}
                           : StationId{static_cast<std::uint16_t>(all.rbegin()->first.value + 1)};
    }
    const auto* joined = std::get_if<fact::ParticipantJoined>(&body);
    if (!joined || asked != kNoStation)
        return asked;
    const StationId last = state.stationOf(joined->participant);
    const StationId place = state.isOpen(last) ? last : firstOpenStation(state);
    return place == kNoStation ? Result<StationId>{fail(Errc::StationUnknown)} : place;
}

Result<void> checkStation(const SessionState& state, StationId station, const FactBody& body)
{
    if (isOfNoStation(body) || std::holds_alternative<fact::StationAdded>(body)
        || state.isOpen(station) || (station == kAllStations && changesPatient(body)))
        return {};
    const auto closed = state.stations().find(station);
    return fail(Errc::StationUnknown, closed != state.stations().end()
                                          ? closed->second.name
                                          : "station " + std::to_string(station.value));
}

Result<void> checkStations(const SessionState& state, StationId station, const FactBody& body)
{
    if (const auto* renamed = std::get_if<fact::StationRenamed>(&body))
        return checkStationName(state, station, renamed->name);
    if (std::holds_alternative<fact::StationClosed>(body))
        return checkClosing(state, station);
    const auto* added = std::get_if<fact::StationAdded>(&body);
    if (!added)
        return {};
    if (numberOpen(state) >= kMostStations || state.stations().size() >= kMostStationsEver)
        return fail(Errc::StationCount, openStationNames(state));
    return checkStationName(state, station, added->name);
}

} // namespace carina
