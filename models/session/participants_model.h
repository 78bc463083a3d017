#pragma once

#include "models/session/session_model.h"

#include <QAbstractTableModel>

#include <span>
#include <vector>

namespace carina
{

struct NetworkFigures;

/// The participants of the session as a table: name, role and who is at work, station, connection
/// state, how far the registration of their manikin can be relied on, how much they send to the
/// host, age of the newest pose sample, and drift: how far this program's view of their objects was
/// from theirs at the same session time.
class ParticipantsModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column {
        Name,
        RoleColumn,
        Station,
        State,
        Registration,
        Sends,
        Age,
        DriftAngle,
        DriftDistance,
        Delay,
        Same, ///< whether they see their objects where this program does; its tool tip has figures
        ColumnCount
    };
    static constexpr int kIdRole = Qt::UserRole;

    /// @pre session outlives this.
    explicit ParticipantsModel(SessionModel& session, QObject* parent = nullptr);

    /// The age of the oldest of all participants' newest samples, in milliseconds; std::nullopt
    /// while nobody sends poses.
    [[nodiscard]] std::optional<double> oldestSample_ms() const;
    /// Whether anybody has a registration to tell of.
    [[nodiscard]] bool hasRegistrations() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

private:
    /// One participant, with the largest age and the largest drift of its objects.
    struct Row {
        ParticipantId id;
        QString name;
        QString role;
        QString station;
        QString state;
        QString reason{};                                   ///< of a removal
        std::optional<RegistrationStanding> registration{}; ///< while present
        std::optional<double> sends_kB_per_s{};
        std::optional<double> age_ms{};
        std::optional<double> drift_deg{};
        std::optional<double> drift_mm{};
        std::optional<double> bound_deg{}; ///< of the drift, up to which it is the same
        std::optional<double> bound_mm{};
        std::optional<double> drift_percent{}; ///< of the size of what is acted on
        std::optional<double> bound_percent{};
        std::optional<double> delay_ms{};  ///< to or from this program, one way
        std::optional<bool> seesTheSame{}; ///< as far as is known
        bool isCompared = false; ///< somebody else is here, whose objects would be compared
        bool owns = false;       ///< an object

        friend bool operator==(const Row&, const Row&) = default;
    };

    void refresh();
    [[nodiscard]] std::vector<Row> currentRows() const;
    static void addNetwork(const std::vector<NetworkFigures>& figures, Row& row);
    [[nodiscard]] QString stateText(const Participant& participant,
                                    std::span<const LinkReport> links) const;
    [[nodiscard]] static QString absenceText(const Participant& participant);
    [[nodiscard]] static QString registrationTip(const RegistrationStanding& registration);
    [[nodiscard]] static QString figuresText(const Row& row);
    [[nodiscard]] static QString sameText(const Row& row);
    [[nodiscard]] static QString sameTip(const Row& row);
    [[nodiscard]] static QString cell(const Row& row, int column);
    /// The text of a cell for a screen reader: with its column name, without the state mark.
    [[nodiscard]] QString spoken(const Row& row, int column) const;

    SessionModel& m_session;
    std::vector<Row> m_rows;
};

} // namespace carina
