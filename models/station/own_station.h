#pragma once

#include "models/session/session_model.h"

namespace carina
{

/// The station where this program's participant is: chosen on joining, later by an instructor.
class OwnStation : public QObject
{
    Q_OBJECT

public:
    /// @pre session outlives this.
    explicit OwnStation(SessionModel& session, QObject* parent = nullptr);

    /// kNoStation until the host has admitted this program.
    [[nodiscard]] StationId id() const { return m_id; }

Q_SIGNALS:
    void changed(carina::StationId station);

private:
    void look();

    SessionModel& m_session;
    StationId m_id;
};

/// "Station: Room 5", where the session has more than one that is open; else empty.
[[nodiscard]] QString stationText(const SessionNode& node);

} // namespace carina
