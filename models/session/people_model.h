#pragma once

#include "models/session/change_history.h"
#include "models/session/session_model.h"

#include <QPointer>
#include <QString>

#include <optional>
#include <vector>

namespace carina
{

/// A side of the patient at which others see a participant.
enum class PatientSide : std::uint8_t { Head, Left, Feet, Right };

/// The turn of PlaceChosen that shows a head at a side of the patient. A head stands at the side
/// that it is nearest to; one that was never seen, at the patient's head.
/// @param X_AH as tracked
[[nodiscard]] Angle turnTo(PatientSide side, const std::optional<RigidTransform>& X_AH);

/// The people who are present at a station: who is at work, and where others see them. Lives on the
/// GUI thread.
class PeopleModel : public QObject
{
    Q_OBJECT

public:
    struct Person {
        ParticipantId id;
        QString name;
        bool isSelf = false;
        bool isAtWork = false;
        bool hasHead = false;    ///< shares a head
        bool canBeGiven = false; ///< the work, by this program's participant
        bool canBePlaced = false;
        bool isPlaced = false; ///< elsewhere than as tracked

        friend bool operator==(const Person&, const Person&) = default;
    };

    /// @pre session outlives this.
    PeopleModel(SessionModel& session, StationId station, QObject* parent = nullptr);

    /// Speaks of another station from now on.
    void setStation(StationId station);
    /// Adds to a history from now on to whom work is given, and where people are placed. What
    /// somebody decided otherwise since, or cannot be any more, is not taken back, and the history
    /// says why. Work that nobody did before is no change of the history: it can be passed on, but
    /// no fact gives it back to nobody.
    void setHistory(ChangeHistory& history) { m_history = &history; }

    /// By the order of joining.
    [[nodiscard]] std::vector<Person> people() const;
    /// Nothing for somebody who is not there.
    [[nodiscard]] std::optional<Person> person(ParticipantId id) const;
    /// Why this program's participant cannot give somebody the work, a sentence; empty where they
    /// can.
    [[nodiscard]] QString obstacleToWork(ParticipantId id) const;
    /// Why this program's participant cannot choose where others see somebody; likewise.
    [[nodiscard]] QString obstacleToPlace(ParticipantId id) const;
    /// A sentence on who is at work.
    [[nodiscard]] QString workText() const;

    /// Gives a person the work, this program's participant included. @pre canBeGiven
    void giveWork(ParticipantId to);
    /// Has others see a person at a side of the patient, or as tracked.
    /// @param ownHead X_AH of this program's participant, which no other program sends it
    /// @pre canBePlaced
    void place(ParticipantId id, std::optional<PatientSide> side,
               const std::optional<PoseSample>& ownHead = {});

Q_SIGNALS:
    /// Any of it may have changed.
    void changed();

private:
    [[nodiscard]] Person personOf(const SessionState& state, const Participant& who) const;
    [[nodiscard]] QString whyNotHere(ParticipantId id) const;
    void takeBackWork(StationId station, ParticipantId before, ParticipantId given);
    void takeBackPlace(const fact::PlaceChosen& before, const fact::PlaceChosen& chosen);
    [[nodiscard]] QString whyWorkStays(StationId station, const fact::WorkTaken& back,
                                       ParticipantId given) const;
    [[nodiscard]] QString whyPlaceStays(const fact::PlaceChosen& before,
                                        const fact::PlaceChosen& chosen) const;

    SessionModel& m_session;
    QPointer<ChangeHistory> m_history;
    StationId m_station;
};

} // namespace carina
