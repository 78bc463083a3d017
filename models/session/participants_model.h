#pragma once

#include "models/session/session_model.h"

#include <QAbstractTableModel>

#include <vector>

namespace carina
{

/// Everybody in the session: who, in which role, whether their program answers, how old their
/// newest sample is, and how far their objects jumped when it came.
class ParticipantsModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Name, State, Age, DriftAngle, DriftDistance, RoleColumn, ColumnCount };

    /// @pre session outlives this.
    explicit ParticipantsModel(SessionModel& session, QObject* parent = nullptr);

    /// Of the newest samples of everybody who is here, in milliseconds; nothing while nobody
    /// tracks.
    [[nodiscard]] std::optional<double> oldestSample_ms() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

private:
    /// One participant; of its objects the oldest and the one that drifted most count.
    struct Row {
        ParticipantId id;
        QString name;
        QString role;
        QString state;
        std::optional<double> age_ms{};
        std::optional<double> drift_deg{};
        std::optional<double> drift_mm{};

        friend bool operator==(const Row&, const Row&) = default;
    };

    void refresh();
    [[nodiscard]] std::vector<Row> currentRows() const;
    [[nodiscard]] std::optional<LinkReport> linkTo(ParticipantId id) const;
    [[nodiscard]] QString stateText(const Participant& participant) const;
    [[nodiscard]] static QString cell(const Row& row, int column);
    /// A cell as a screen reader says it: with its column, and without a shape.
    [[nodiscard]] QString spoken(const Row& row, int column) const;

    SessionModel& m_session;
    std::vector<Row> m_rows;
};

} // namespace carina
