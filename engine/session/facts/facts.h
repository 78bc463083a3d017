#pragma once

#include "engine/core/ids.h"
#include "engine/core/session_time.h"
#include "engine/core/units.h"
#include "engine/session/airway/airway_facts.h"
#include "engine/session/body/body_facts.h"
#include "engine/session/facts/conduct_facts.h"
#include "engine/session/facts/lesson_facts.h"
#include "engine/session/facts/people_facts.h"
#include "engine/session/facts/registration_facts.h"
#include "engine/session/respiration/respiration_facts.h"
#include "engine/sync/strategies/strategy_choice.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace carina
{

enum class SessionPhase : std::uint8_t { Prepared, Running, Paused, Ended };
enum class ObjectKind : std::uint8_t {
    Head,
    Jaw,
    Tube,
    Stylus,
    Patient, ///< the virtual patient as drawn; not tracked, moved by actions
    Hand,
    OrganGroup, ///< a group of the patient's organs, whose name is groupName(): lifted out of it
    SpareTube,  ///< a second tube beside the patient: taken out
    Laryngoscope,
    View,    ///< the camera of an instructor who shows a lesson: x right, y up, looking along -z
    Pointer, ///< what that instructor points with: the tip at the origin, pointing along -z
};

/// The kinds of facts: what may be decided or happen in a session. Station, author and effect time
/// are in the enclosing Fact.
namespace fact
{

/// The first fact of every log.
struct SessionCreated {
    std::string name;
    std::string sessionId; ///< 128 random bits in hexadecimal

    friend bool operator==(const SessionCreated&, const SessionCreated&) = default;
};
/// The session starts, pauses, resumes or ends, for all stations.
struct PhaseChanged {
    SessionPhase phase = SessionPhase::Prepared;

    friend bool operator==(const PhaseChanged&, const PhaseChanged&) = default;
};
/// A station is open from now on; its number is that of the fact.
struct StationAdded {
    std::string name;

    friend bool operator==(const StationAdded&, const StationAdded&) = default;
};
/// A participant joined at the station of the fact, for the first time or again: the same name and
/// role give the same id.
struct ParticipantJoined {
    ParticipantId participant;
    Role role = Role::Observer;
    std::string name;

    friend bool operator==(const ParticipantJoined&, const ParticipantJoined&) = default;
};
/// A participant left on purpose, or the host ended the connection of their program.
struct ParticipantLeft {
    ParticipantId participant;

    friend bool operator==(const ParticipantLeft&, const ParticipantLeft&) = default;
};
/// An object is shared from now on, by this owner.
struct ObjectShared {
    ObjectId object;
    ParticipantId owner;
    ObjectKind kind = ObjectKind::Tube;
    std::string name;

    friend bool operator==(const ObjectShared&, const ObjectShared&) = default;
};
/// A shared object passes from its owner to another participant. One that can be lifted out is
/// lifted by passing from nobody to a participant, and put back by passing to nobody.
struct ObjectHandedOver {
    ObjectId object;
    ParticipantId owner;     ///< the new one; kNobody puts it back
    std::uint16_t epoch = 0; ///< of the ownership that ends: void where another has taken its place

    friend bool operator==(const ObjectHandedOver&, const ObjectHandedOver&) = default;
};
/// The author asks for ownership of a shared object, or withdraws the request. A request stands
/// until the author owns the object or leaves, or the object is put back.
struct ObjectWanted {
    ObjectId object;
    bool wanted = true;

    friend bool operator==(const ObjectWanted&, const ObjectWanted&) = default;
};
/// The anatomy of the station's patient, by content hash and name.
struct AnatomyChosen {
    std::string contentHash;
    std::string name;

    friend bool operator==(const AnatomyChosen&, const AnatomyChosen&) = default;
};
struct BreathingRateSet {
    Frequency rate;

    friend bool operator==(const BreathingRateSet&, const BreathingRateSet&) = default;
};
struct TidalVolumeSet {
    Volume tidalVolume;

    friend bool operator==(const TidalVolumeSet&, const TidalVolumeSet&) = default;
};
/// Share of a breath that is inspiration: 0.41 is an I:E of 1:1.44.
struct InspiratoryFractionSet {
    double fraction = 0.4;

    friend bool operator==(const InspiratoryFractionSet&, const InspiratoryFractionSet&) = default;
};
/// How acted-on objects are kept alike from now on, at all stations.
struct StrategyChosen {
    StrategyChoice choice;

    friend bool operator==(const StrategyChosen&, const StrategyChosen&) = default;
};
struct StationRenamed {
    std::string name;

    friend bool operator==(const StationRenamed&, const StationRenamed&) = default;
};
/// Nobody comes to the station any more, and nothing about it changes.
struct StationClosed {
    friend bool operator==(const StationClosed&, const StationClosed&) = default;
};
/// A participant is at the station of the fact from now on, with the tools they share. Of what they
/// owned at the former station, what was lifted out is put back, and the rest passes to the host.
struct ParticipantMoved {
    ParticipantId participant;

    friend bool operator==(const ParticipantMoved&, const ParticipantMoved&) = default;
};

} // namespace fact

/// The index of an alternative defines the kind byte on the wire and on disk: add new ones at the
/// end.
using FactBody = std::variant<
    fact::SessionCreated, fact::PhaseChanged, fact::StationAdded, fact::ParticipantJoined,
    fact::ParticipantLeft, fact::ObjectShared, fact::AnatomyChosen, fact::BreathingRateSet,
    fact::TidalVolumeSet, fact::InspiratoryFractionSet, fact::ObjectHandedOver, fact::ObjectWanted,
    fact::PatientBuildSet, fact::LungConditionsSet, fact::VentilatorSet, fact::TubePlaced,
    fact::ManikinBreathed, fact::RespirationCheckpoint, fact::BodyPositionSet,
    fact::ParticipantMuted, fact::ParticipantRemoved, fact::BanLifted, fact::SessionLocked,
    fact::RoleCodeChanged, fact::TokenReplaced, fact::StrategyChosen, fact::RegistrationStated,
    fact::StationRenamed, fact::StationClosed, fact::ParticipantMoved, fact::WorkTaken,
    fact::PlaceChosen, fact::BreathingStopped, fact::BagSqueezed, fact::LessonShown,
    fact::LessonEnded, fact::ParticipantFellSilent, fact::AirwayEventsSet, fact::HeadPositionSet,
    fact::GasSupplySet, fact::DrugGiven, fact::CuffSet, fact::StyletDrawn, fact::IntubationNoted,
    fact::CapnographCheckpoint, fact::BodyCheckpoint, fact::TubeObstructed, fact::TryEnded>;

/// Whether programs propose such facts automatically, so that no person waits for the result.
[[nodiscard]] inline bool isByItself(const FactBody& body)
{
    return std::holds_alternative<fact::ManikinBreathed>(body)
           || std::holds_alternative<fact::RespirationCheckpoint>(body)
           || std::holds_alternative<fact::RegistrationStated>(body)
           || std::holds_alternative<fact::IntubationNoted>(body)
           || std::holds_alternative<fact::CapnographCheckpoint>(body)
           || std::holds_alternative<fact::BodyCheckpoint>(body);
}

/// Whether a fact changes who is present.
[[nodiscard]] inline bool changesPresence(const FactBody& body)
{
    return std::holds_alternative<fact::ParticipantJoined>(body)
           || std::holds_alternative<fact::ParticipantLeft>(body)
           || std::holds_alternative<fact::ParticipantFellSilent>(body)
           || std::holds_alternative<fact::ParticipantRemoved>(body);
}

/// Whether a fact may bring a participant to another station, and with them what they own.
[[nodiscard]] inline bool changesPlace(const FactBody& body)
{
    return std::holds_alternative<fact::ParticipantJoined>(body)
           || std::holds_alternative<fact::ParticipantMoved>(body);
}

/// Whether a fact may change the owner of objects that it does not name.
[[nodiscard]] inline bool mayChangeOwners(const FactBody& body)
{
    return changesPlace(body) || changesPresence(body);
}

/// Whether objects of this kind have a place at their station, where nobody owns them until
/// somebody lifts them out.
[[nodiscard]] constexpr bool isLiftable(ObjectKind kind)
{
    return kind == ObjectKind::OrganGroup || kind == ObjectKind::SpareTube;
}

/// Whether objects of this kind are moved by actions; all others are tracked.
[[nodiscard]] constexpr bool isActedOn(ObjectKind kind)
{
    return kind == ObjectKind::Patient || isLiftable(kind);
}

/// Whether objects of this kind belong to a lesson: only instructors have them.
[[nodiscard]] constexpr bool isOfLesson(ObjectKind kind)
{
    return kind == ObjectKind::View || kind == ObjectKind::Pointer;
}

/// Whether objects of this kind are tools or parts of a person, which go where the person goes; the
/// others stay at their station.
[[nodiscard]] constexpr bool isCarried(ObjectKind kind) { return !isActedOn(kind); }

/// The object whose ownership a fact changes; nothing for other facts.
[[nodiscard]] inline std::optional<ObjectId> objectOf(const FactBody& body)
{
    if (const auto* shared = std::get_if<fact::ObjectShared>(&body))
        return shared->object;
    if (const auto* handed = std::get_if<fact::ObjectHandedOver>(&body))
        return handed->object;
    return std::nullopt;
}

/// A fact proposed to the host.
struct Proposal {
    ProposalId id;
    ParticipantId author;
    StationId station;
    FactBody body;

    friend bool operator==(const Proposal&, const Proposal&) = default;
};

/// One entry of the append-only log: numbered by the host, and on disk before anyone receives it.
struct Fact {
    FactNumber number;   ///< position in the log, from 1 without gaps
    ProposalId proposal; ///< the proposal it came from
    ParticipantId author;
    StationId station;
    SessionTime committed{}; ///< when the host put it on disk
    SessionTime effect{};    ///< when it takes effect everywhere
    FactBody body;

    friend bool operator==(const Fact&, const Fact&) = default;
};

} // namespace carina
