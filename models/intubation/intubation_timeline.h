#pragma once

#include "engine/airway/monitor/intubation_event.h"
#include "models/session/session_model.h"

#include <QAbstractListModel>

#include <vector>

namespace carina
{

/// Something that happened, and the line that tells it.
struct TimelineEntry {
    SessionTime at{};
    QString text;

    friend bool operator==(const TimelineEntry&, const TimelineEntry&) = default;
};

/// The steps of the intubations at one station, as its monitor noted them, in the order in which
/// they happened, one in a line: "00:48  Tube at rest, 20.1 cm at the teeth"; among them where the
/// console set the tube, and the drugs that were given. The time is the session's running time.
/// Lives on the GUI thread.
class IntubationTimeline : public QAbstractListModel
{
    Q_OBJECT

public:
    /// @pre session outlives this.
    IntubationTimeline(SessionModel& session, StationId station, QObject* parent = nullptr);

    /// Tells of another station from now on.
    void setStation(StationId station);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    /// The latest step that is not later than a moment; the first where all are, -1 where there is
    /// none.
    [[nodiscard]] int rowAt(SessionTime moment) const;

private:
    void refresh();

    SessionModel& m_session;
    StationId m_station;
    std::vector<TimelineEntry> m_lines; ///< in ascending time
};

/// From this confidence on something is told, and not asked. Of ours.
inline constexpr double kLeastTold = 0.5;

/// What is told with little confidence says so, and what is less likely than not is asked:
/// "In the oesophagus", "In the oesophagus (64 % sure)", "Through the cords? (25 % sure)".
[[nodiscard]] QString asSureAs(const QString& what, double confidence);

/// What happened, and what was measured of it: "In the right main bronchus, 26.3 cm at the teeth".
[[nodiscard]] QString intubationText(const IntubationEvent& event);

} // namespace carina
