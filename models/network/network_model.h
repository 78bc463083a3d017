#pragma once

#include "models/network/network_figures.h"
#include "models/session/session_model.h"

#include <QAbstractListModel>

#include <map>

namespace carina
{

/// Everybody whom this program measures a path to, by name, each with the figures of the network
/// between.
class NetworkModel : public QAbstractListModel
{
    Q_OBJECT

public:
    static constexpr int kIdRole = Qt::UserRole;

    /// @pre session outlives this.
    explicit NetworkModel(SessionModel& session, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

    /// Nothing for a row that is none.
    [[nodiscard]] std::optional<NetworkFigures> figures(int row) const;

Q_SIGNALS:
    /// There are newer figures, of the same or of other participants.
    void measured();

private:
    /// An offset when it was first known.
    struct FirstOffset {
        double offset_s = 0.0;
        double error_ms = 0.0;
    };

    void refresh();
    [[nodiscard]] std::vector<NetworkFigures> measure();

    SessionModel& m_session;
    std::map<ParticipantId, FirstOffset> m_firstOffsets; ///< of those who are here
    std::vector<NetworkFigures> m_figures;
};

} // namespace carina
