#include "engine/session/news_rules.h"

#include "engine/core/overloaded.h"

#include <algorithm>

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

Result<void> checkStep(const SessionState& state, const Fact& fact, const IntubationEvent& event)
{
    if (event.at > fact.effect || fact.effect - event.at > kLongestNews)
        return fail(Errc::OutOfRange, "a step of an intubation that is not of the present");
    const auto station = state.stations().find(fact.station);
    if (station == state.stations().end())
        return {};
    const bool isRepeated =
        std::ranges::any_of(station->second.respiration.tube().notes(), [&](const NotedStep& note) {
            return note.event.step == event.step && event.at - note.event.at < kShortestStep;
        });
    return isRepeated ? fail(Errc::OutOfRange, "a step of an intubation too soon after the last")
                      : Result<void>{};
}

/// Whether the session is already as the fact says.
bool isSaid(const SessionState& state, const Fact& fact)
{
    const auto known = [](const auto& entries, auto id) {
        const auto found = entries.find(id);
        return found == entries.end() ? nullptr : &found->second;
    };
    return std::visit(
        Overloaded{
            [&](const fact::RegistrationStated& f) {
                const Participant* who = known(state.participants(), fact.author);
                return who && who->registration == f.standing;
            },
            [&](const fact::PlaceChosen& f) {
                const Participant* who = known(state.participants(), f.participant);
                return who && who->turn == f.turn;
            },
            [&](const fact::ObjectWanted& f) {
                const SharedObject* object = known(state.objects(), f.object);
                return object
                       && f.wanted
                              == (std::ranges::find(object->wantedBy, fact.author)
                                  != object->wantedBy.end());
            },
            [&](const fact::ObjectHandedOver& f) {
                const SharedObject* object = known(state.objects(), f.object);
                return object && object->owner == f.owner;
            },
            [&](const fact::CuffSet& f) {
                const Station* station = known(state.stations(), fact.station);
                return station
                       && station->respiration.tube().cuffInflatedAt(SessionTime::max())
                              == f.inflated;
            },
            [&](const fact::StyletDrawn&) {
                const Station* station = known(state.stations(), fact.station);
                return station && !station->respiration.tube().styletInAt(SessionTime::max());
            },
            [&](const fact::TryEnded&) { // of the same try
                const Station* station = known(state.stations(), fact.station);
                return station && !station->tryEnds.empty()
                       && station->tryEnds.back() > fact.committed;
            },
            [&](const fact::LessonShown& f) {
                const Station* station = known(state.stations(), fact.station);
                return station && station->lesson == ShownLesson{fact.author, f.to, f.lesson};
            },
            [](const auto&) { return false; }},
        fact.body);
}

} // namespace

Result<void> checkNews(const SessionState& state, const Fact& fact)
{
    if (const auto* breathed = std::get_if<fact::ManikinBreathed>(&fact.body))
        return checkBreath(state, fact, breathed->began);
    if (const auto* noted = std::get_if<fact::IntubationNoted>(&fact.body))
        return checkStep(state, fact, noted->event);
    return isSaid(state, fact) ? fail(Errc::OutOfRange, "it changes nothing") : Result<void>{};
}

} // namespace carina
