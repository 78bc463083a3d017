#pragma once

#include "engine/anatomy/patient/patient_dimensions.h"
#include "models/session/change_history.h"
#include "models/session/session_model.h"

#include <QPointer>

#include <vector>

namespace carina
{

/// The stations of a session as an instructor runs them: which one is shown, whether a change of
/// the patient is for all, and who is where. Lives on the GUI thread.
class StationsModel : public QObject
{
    Q_OBJECT

public:
    struct Row {
        StationId id;
        QString name;
        int present = 0; ///< participants who are there

        friend bool operator==(const Row&, const Row&) = default;
    };

    /// Shows this program's own station first. @pre session outlives this.
    explicit StationsModel(SessionModel& session, QObject* parent = nullptr);

    /// Adds names and moves to a history from now on, and tells it which stations there are. What
    /// cannot be taken back stays, and the history says why.
    void setHistory(ChangeHistory& history);

    /// Those that are open, in the order of their numbers.
    [[nodiscard]] const std::vector<Row>& open() const { return m_open; }
    /// One of the open ones; kNoStation before there is any.
    [[nodiscard]] StationId shown() const { return m_shown; }
    void show(StationId station);
    /// Whether changes of breathing, condition and airway are for all stations; never while one is
    /// open.
    [[nodiscard]] bool isForAll() const { return m_forAll && m_open.size() > 1; }
    void setForAll(bool all);

    [[nodiscard]] QString nameOf(StationId station) const;
    [[nodiscard]] StationId stationOf(ParticipantId participant) const;

    // One sentence: why this cannot be done; empty if it can.
    [[nodiscard]] QString obstacleToAdding() const;
    [[nodiscard]] QString obstacleToClosing(StationId station) const;
    /// @param self the station that is to get the name; kNoStation for a new one
    [[nodiscard]] QString faultOfName(const QString& name, StationId self) const;
    /// @param patient as patientFromWords reads it
    [[nodiscard]] static QString faultOfPatient(const QString& patient);

    enum class After : std::uint8_t { ShowIt, StayHere };
    /// Opens a station, and lays the patient there.
    /// @pre no obstacle, and no fault of the name and the patient.
    void add(const QString& name, const QString& patient, After after = After::ShowIt);
    void rename(StationId station, const QString& name);
    /// Closes a station; who runs this program goes to another one, if they were at it.
    void close(StationId station);
    /// Taken back, it brings them where they were with the tools that they carry; what else they
    /// owned there they had to leave, and do not get again.
    void move(ParticipantId participant, StationId station);

Q_SIGNALS:
    /// The open stations, their names, or how many are there changed.
    void changed();
    void shownChanged(carina::StationId station);
    void forAllChanged(bool all);

private:
    /// A station that this program opens: until its fact has arrived it has no number.
    struct Opened {
        QString name;
        PatientParameters patient;
        After after = After::ShowIt;
    };

    void refresh();
    void layPatients();
    void tellForAll();
    void tellHistory();
    void bring(ParticipantId participant, StationId station);
    void takeBackName(StationId station, const QString& before, const QString& given);
    void takeBackMove(ParticipantId participant, StationId from, StationId to);
    [[nodiscard]] QString whyNameStays(StationId station, const QString& before,
                                       const QString& given) const;
    [[nodiscard]] QString whyMoveStays(ParticipantId participant, StationId from,
                                       StationId to) const;

    SessionModel& m_session;
    QPointer<ChangeHistory> m_history;
    std::vector<Row> m_open;
    StationId m_shown = kNoStation;
    bool m_forAll = false;
    bool m_toldForAll = false;
    std::vector<Opened> m_opened;
};

} // namespace carina
