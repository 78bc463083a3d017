#include "engine/session/news_rules.h"

namespace carina
{
namespace
{

Result<void> checkBreath(const SessionState& state, const Fact& fact, SessionTime began)
{
    if (began > fact.effect || fact.effect - began > kLongestNews)
        return fail(Errc::OutOfRange, "a breath of the manikin that is not of the present");
    const auto station = state.stations().find(fact.station);
    if (station == state.stations().end() || station->second.respiration.breaths().empty())
        return {};
    const SessionTime last = station->second.respiration.breaths().back().began;
    return began - last < kShortestBreath
               ? fail(Errc::OutOfRange, "a breath of the manikin too soon after the last")
               : Result<void>{};
}

} // namespace

Result<void> checkNews(const SessionState& state, const Fact& fact)
{
    if (const auto* breathed = std::get_if<fact::ManikinBreathed>(&fact.body))
        return checkBreath(state, fact, breathed->began);
    const auto* stated = std::get_if<fact::RegistrationStated>(&fact.body);
    const auto* chosen = std::get_if<fact::PlaceChosen>(&fact.body);
    if (!stated && !chosen)
        return {};
    const auto whose = state.participants().find(stated ? fact.author : chosen->participant);
    if (whose == state.participants().end())
        return {};
    const Participant& participant = whose->second;
    const bool isSaid =
        stated ? participant.registration == stated->standing : participant.turn == chosen->turn;
    return isSaid ? fail(Errc::OutOfRange, "it changes nothing") : Result<void>{};
}

} // namespace carina
