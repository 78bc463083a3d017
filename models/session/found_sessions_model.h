#pragma once

#include "engine/net/discovery/session_finder.h"

#include <QAbstractListModel>

namespace carina
{

/// The sessions that can be joined from this computer; searched for as long as this exists.
class FoundSessionsModel : public QAbstractListModel
{
    Q_OBJECT

public:
    explicit FoundSessionsModel(std::uint16_t discoveryPort = kDiscoveryPort,
                                QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    /// @pre row is one of rowCount().
    [[nodiscard]] const FoundSession& at(int row) const;

private:
    void refresh();

    std::vector<FoundSession> m_shown;
    SessionFinder m_finder;
};

} // namespace carina
