#pragma once

#include "models/network/network_figures.h"
#include "models/network/strategy_model.h"
#include "models/session/session_model.h"

#include <QAbstractListModel>

#include <map>

namespace carina
{

/// The participants to whom this program measures a network path, by name, with the figures of each
/// path.
class NetworkModel : public QAbstractListModel
{
    Q_OBJECT

public:
    static constexpr int kIdRole = Qt::UserRole;

    /// @pre session outlives this.
    explicit NetworkModel(SessionModel& session, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

    /// std::nullopt for a row that does not exist.
    [[nodiscard]] std::optional<NetworkFigures> figures(int row) const;
    /// The row of who came in last, above the own; -1 where nobody did.
    [[nodiscard]] int newest() const;
    /// How the session keeps acted-on objects alike.
    [[nodiscard]] StrategyModel& strategy() { return m_strategy; }

Q_SIGNALS:
    /// The figures, or the list of participants, were updated.
    void measured();

private:
    /// The first estimate of a clock offset.
    struct FirstOffset {
        double offset_s = 0.0;
        double error_ms = 0.0;
    };

    void refresh();
    [[nodiscard]] std::vector<NetworkFigures> measure();

    SessionModel& m_session;
    StrategyModel m_strategy;
    std::map<ParticipantId, FirstOffset> m_firstOffsets; ///< of the participants listed now
    std::vector<NetworkFigures> m_figures;
};

} // namespace carina
