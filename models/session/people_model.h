#pragma once

#include "models/session/session_model.h"

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

    /// By the order of joining.
    [[nodiscard]] std::vector<Person> people() const;
    /// Nothing for somebody who is not there.
    [[nodiscard]] std::optional<Person> person(ParticipantId id) const;
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

    SessionModel& m_session;
    StationId m_station;
};

} // namespace carina
