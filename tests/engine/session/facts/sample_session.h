#pragma once

#include "engine/session/session_authority.h"

#include <cstdint>
#include <vector>

namespace carina::test
{

inline SessionTime atSeconds(double seconds) { return SessionTime{fromSeconds(seconds)}; }

inline constexpr ParticipantId kSampleHost{0};
inline constexpr ParticipantId kSampleInstructor{1};
inline constexpr ParticipantId kSampleTrainee{2};
inline constexpr ParticipantId kSampleObserver{3};
inline constexpr ParticipantId kSampleOtherTrainee{4};
inline constexpr StationId kSampleStation{0};
inline constexpr ObjectId kSampleTube{1}; ///< of kSampleTrainee

/// Facts numbered one after the other, each in effect when it is committed.
class LogWriter
{
public:
    const Fact& add(SessionTime effect, FactBody body, StationId station = kSampleStation,
                    ParticipantId author = kSampleHost)
    {
        const std::uint64_t number = m_log.size() + 1;
        m_log.push_back(Fact{FactNumber{number}, ProposalId{1000 + number}, author, station, effect,
                             effect, std::move(body)});
        return m_log.back();
    }
    [[nodiscard]] const std::vector<Fact>& log() const { return m_log; }

private:
    std::vector<Fact> m_log;
};

/// A session with one station and one of everybody, not started yet.
inline LogWriter sampleSession()
{
    LogWriter writer;
    const SessionTime start = atSeconds(0.0);
    writer.add(start, fact::SessionCreated{"Routine intubation", "00ff"});
    writer.add(start, fact::StationAdded{"Station 1"});
    writer.add(start, fact::ParticipantJoined{kSampleInstructor, Role::Instructor, "Ina"});
    writer.add(start, fact::ParticipantJoined{kSampleTrainee, Role::Trainee, "Tom"});
    writer.add(start, fact::ParticipantJoined{kSampleObserver, Role::Observer, "Olga"});
    writer.add(start, fact::ParticipantJoined{kSampleOtherTrainee, Role::Trainee, "Tess"});
    writer.add(start, fact::ObjectShared{kSampleTube, kSampleTrainee, ObjectKind::Tube, "tube"});
    return writer;
}

inline SessionState stateOf(const LogWriter& writer)
{
    SessionState state;
    for (const Fact& fact : writer.log())
        state.apply(fact);
    return state;
}

inline const RespirationTimeline& timelineOf(const SessionState& state)
{
    return state.stations().at(kSampleStation).respiration;
}

} // namespace carina::test
