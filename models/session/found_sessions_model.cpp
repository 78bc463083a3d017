#include "models/session/found_sessions_model.h"

#include <algorithm>

namespace carina
{

FoundSessionsModel::FoundSessionsModel(std::uint16_t discoveryPort, QObject* parent)
    : QAbstractListModel{parent}, m_finder{[this] { refresh(); }, discoveryPort}
{
}

void FoundSessionsModel::lookFor(const SessionKey& session)
{
    m_known = session;
    m_finder.lookFor(session);
}

bool FoundSessionsModel::isKnown(const FoundSession& found) const
{
    return m_known == found.notice.session;
}

std::optional<int> FoundSessionsModel::knownRow() const
{
    for (int row = 0; row < rowCount(); ++row)
        if (isKnown(at(row)))
            return row;
    return std::nullopt;
}

int FoundSessionsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_shown.size());
}

QVariant FoundSessionsModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || (role != Qt::DisplayRole && role != Qt::AccessibleTextRole))
        return {};
    const FoundSession& found = at(index.row());
    const QString name = QString::fromStdString(found.notice.name).simplified();
    const QString address = QString::fromStdString(found.address);
    const QString port = QString::number(found.notice.port);
    const QString text = found.isOnThisComputer()
                             ? tr("%1, on this computer, port %2").arg(name, port)
                             : tr("%1, at %2, port %3").arg(name, address, port);
    return isKnown(found) ? tr("%1: you were here last", "a session").arg(text) : text;
}

const FoundSession& FoundSessionsModel::at(int row) const
{
    return m_shown.at(static_cast<std::size_t>(row));
}

void FoundSessionsModel::refresh()
{
    // Only what changed, so that a choice stays where it was made.
    const auto now = m_finder.sessions();
    for (int row = rowCount() - 1; row >= 0; --row) {
        if (std::ranges::find(now, at(row)) != now.end())
            continue;
        beginRemoveRows({}, row, row);
        m_shown.erase(m_shown.begin() + row);
        endRemoveRows();
    }
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (i < m_shown.size() && m_shown[i] == now[i])
            continue;
        beginInsertRows({}, static_cast<int>(i), static_cast<int>(i));
        m_shown.insert(m_shown.begin() + static_cast<std::ptrdiff_t>(i), now[i]);
        endInsertRows();
    }
}

} // namespace carina
