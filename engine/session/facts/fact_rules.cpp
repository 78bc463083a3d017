#include "engine/session/facts/fact_rules.h"

#include "engine/session/airway/airway_rules.h"
#include "engine/session/body/body_rules.h"
#include "engine/session/facts/number_check.h"
#include "engine/session/facts/utf8.h"
#include "engine/session/lesson_rules.h"
#include "engine/session/respiration/respiration_rules.h"
#include "engine/sync/strategies/probe_trigger.h"

#include <initializer_list>
#include <string>

namespace carina
{

namespace
{

Result<void> checkTexts(std::initializer_list<const std::string*> texts)
{
    for (const std::string* text : texts) {
        if (text->size() > kLongestText)
            return fail(Errc::OutOfRange, "a text of " + std::to_string(text->size()) + " bytes ("
                                              + std::to_string(kLongestText) + " at most)");
        if (!isUtf8(*text))
            return fail(Errc::OutOfRange, "a text that is not UTF-8");
    }
    return {};
}

/// Rates of probes, per second, and numbers of delays that the ASA can be given.
constexpr double kSlowestProbes = 0.1;
constexpr double kMostDelays = 1000.0;

Result<void> checkChoice(const StrategyChoice& choice)
{
    const AsaParameters& asa = choice.asa;
    return checkNumber("number of delays", asa.delays, 1.0, kMostDelays, "")
        .and_then([&] {
            return checkNumber("lowest rate of probes", asa.lowest, kSlowestProbes, kFastestProbes,
                               " /s");
        })
        .and_then([&] {
            return checkNumber("highest rate of probes", asa.highest, asa.lowest, kFastestProbes,
                               " /s");
        })
        .and_then([&] {
            return checkNumber("rate of probes at the start", asa.start, asa.lowest, asa.highest,
                               " /s");
        })
        .and_then([&] {
            return checkNumber("local lag", toSeconds(choice.longestLag) * 1e3, 0.0,
                               toSeconds(kLongestLocalLag) * 1e3, " ms");
        });
}

constexpr double kLargestError_mm = 1000.0;

Result<void> checkStanding(const RegistrationStanding& standing)
{
    const bool mustHaveReason = standing.state == RegistrationState::Stale;
    const bool mayHaveReason = mustHaveReason || standing.state == RegistrationState::Unverified;
    const bool hasReason = standing.reason != StaleReason::None;
    if (hasReason ? !mayHaveReason : mustHaveReason)
        return fail(Errc::OutOfRange, "the reason why a registration is stale");
    return checkNumber("error of a registration", inMillimetres(standing.error), 0.0,
                       kLargestError_mm, " mm");
}

struct BodyCheck {
    Result<void> operator()(const fact::SessionCreated& f) const
    {
        return checkTexts({&f.name, &f.sessionId});
    }
    Result<void> operator()(const fact::PhaseChanged&) const { return {}; }
    Result<void> operator()(const fact::StationAdded& f) const { return checkTexts({&f.name}); }
    Result<void> operator()(const fact::ParticipantJoined& f) const
    {
        return checkTexts({&f.name});
    }
    Result<void> operator()(const fact::ParticipantLeft&) const { return {}; }
    Result<void> operator()(const fact::ParticipantFellSilent&) const { return {}; }
    Result<void> operator()(const fact::ObjectShared& f) const
    {
        if (isLiftable(f.kind) != (f.owner == kNobody))
            return fail(Errc::OutOfRange, "the owner of a new object");
        return checkTexts({&f.name});
    }
    Result<void> operator()(const fact::ObjectHandedOver&) const { return {}; }
    Result<void> operator()(const fact::ObjectWanted&) const { return {}; }
    Result<void> operator()(const fact::AnatomyChosen& f) const
    {
        return checkTexts({&f.contentHash, &f.name});
    }
    Result<void> operator()(const fact::BreathingRateSet& f) const
    {
        return checkNumber("breathing rate", inPerMinute(f.rate), inPerMinute(kSlowestBreathing),
                           inPerMinute(kFastestBreathing), " /min");
    }
    Result<void> operator()(const fact::TidalVolumeSet& f) const
    {
        return checkNumber("tidal volume", inMillilitres(f.tidalVolume),
                           inMillilitres(kSmallestTidalVolume), inMillilitres(kLargestTidalVolume),
                           " ml");
    }
    Result<void> operator()(const fact::InspiratoryFractionSet& f) const
    {
        return checkNumber("inspiratory fraction", f.fraction, kShortestInspiration,
                           kLongestInspiration, "");
    }
    Result<void> operator()(const fact::ParticipantMuted&) const { return {}; }
    Result<void> operator()(const fact::ParticipantRemoved& f) const
    {
        return checkTexts({&f.reason});
    }
    Result<void> operator()(const fact::BanLifted&) const { return {}; }
    Result<void> operator()(const fact::SessionLocked&) const { return {}; }
    Result<void> operator()(const fact::RoleCodeChanged&) const { return {}; }
    Result<void> operator()(const fact::TokenReplaced&) const { return {}; }
    Result<void> operator()(const fact::StrategyChosen& f) const { return checkChoice(f.choice); }
    Result<void> operator()(const fact::RegistrationStated& f) const
    {
        return checkStanding(f.standing);
    }
    Result<void> operator()(const fact::StationRenamed& f) const { return checkTexts({&f.name}); }
    Result<void> operator()(const fact::StationClosed&) const { return {}; }
    Result<void> operator()(const fact::ParticipantMoved&) const { return {}; }
    Result<void> operator()(const fact::WorkTaken&) const { return {}; }
    Result<void> operator()(const fact::PlaceChosen& f) const
    {
        return checkNumber("turn", inDegrees(f.turn), -180.0, 180.0, " deg");
    }
    Result<void> operator()(const fact::LessonShown& f) const { return checkLesson(f.lesson); }
    Result<void> operator()(const fact::LessonEnded&) const { return {}; }
    Result<void> operator()(const fact::AirwayEventsSet& f) const { return checkAirway(f); }
    Result<void> operator()(const fact::HeadPositionSet& f) const { return checkAirway(f); }
    Result<void> operator()(const fact::GasSupplySet& f) const { return checkPatientBody(f); }
    Result<void> operator()(const fact::DrugGiven& f) const { return checkPatientBody(f); }
    Result<void> operator()(const fact::CuffSet&) const { return {}; }
    Result<void> operator()(const fact::StyletDrawn&) const { return {}; }
    Result<void> operator()(const fact::TryEnded&) const { return {}; }
    Result<void> operator()(const fact::TubeObstructed& f) const { return checkPatientBody(f); }
    Result<void> operator()(const fact::IntubationNoted& f) const { return checkPatientBody(f); }
    Result<void> operator()(const fact::CapnographCheckpoint& f) const
    {
        return checkPatientBody(f);
    }
    Result<void> operator()(const fact::BodyCheckpoint& f) const { return checkPatientBody(f); }
    template <class Fact> Result<void> operator()(const Fact& f) const
    {
        return checkRespiration(f);
    }
};

} // namespace

Result<void> checkBody(const FactBody& body) { return std::visit(BodyCheck{}, body); }

} // namespace carina
