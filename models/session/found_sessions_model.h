#pragma once

#include "engine/net/discovery/session_finder.h"

#include <QAbstractListModel>

#include <optional>

namespace carina
{

/// The sessions that can be joined from this computer; searched for as long as this exists.
class FoundSessionsModel : public QAbstractListModel
{
    Q_OBJECT

public:
    explicit FoundSessionsModel(std::uint16_t discoveryPort = kDiscoveryPort,
                                QObject* parent = nullptr);

    /// Looks for this session, too, also where it is joined by link: where this program was last.
    void lookFor(const SessionKey& session);
    /// Its row; std::nullopt while it is not found.
    [[nodiscard]] std::optional<int> knownRow() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    /// @pre row is one of rowCount().
    [[nodiscard]] const FoundSession& at(int row) const;

private:
    void refresh();
    [[nodiscard]] bool isKnown(const FoundSession& found) const;

    std::vector<FoundSession> m_shown;
    std::optional<SessionKey> m_known;
    SessionFinder m_finder;
};

} // namespace carina
