#include "models/network/network_model.h"

#include <QTimer>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr int kMeasureInterval_ms = 500;

bool samePeople(const std::vector<NetworkFigures>& a, const std::vector<NetworkFigures>& b)
{
    return std::ranges::equal(a, b, [](const NetworkFigures& x, const NetworkFigures& y) {
        return x.id == y.id && x.name == y.name;
    });
}

} // namespace

NetworkModel::NetworkModel(SessionModel& session, QObject* parent)
    : QAbstractListModel{parent}, m_session{session}, m_strategy{session}, m_figures{measure()}
{
    connect(&m_session, &SessionModel::changed, this, &NetworkModel::refresh);
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &NetworkModel::refresh);
    timer->start(kMeasureInterval_ms);
}

int NetworkModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_figures.size());
}

QVariant NetworkModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const NetworkFigures& figures = m_figures[std::size_t(index.row())];
    if (role == Qt::DisplayRole)
        return figures.isOwn ? tr("%1 (you)").arg(figures.name) : figures.name;
    if (role == kIdRole)
        return figures.id.value;
    return {};
}

std::optional<NetworkFigures> NetworkModel::figures(int row) const
{
    if (row < 0 || row >= rowCount())
        return std::nullopt;
    return m_figures[std::size_t(row)];
}

int NetworkModel::newest() const
{
    const bool endsWithOwn = !m_figures.empty() && m_figures.back().isOwn;
    return rowCount() - (endsWithOwn ? 2 : 1);
}

std::vector<NetworkFigures> NetworkModel::measure()
{
    std::vector<NetworkFigures> figures = networkFigures(m_session.node());
    std::map<ParticipantId, FirstOffset> firstOffsets;
    for (NetworkFigures& one : figures) {
        if (!one.clockOffset_s || !one.clockError_ms)
            continue;
        const auto known = m_firstOffsets.find(one.id);
        const FirstOffset first = known != m_firstOffsets.end()
                                      ? known->second
                                      : FirstOffset{*one.clockOffset_s, *one.clockError_ms};
        firstOffsets.emplace(one.id, first);
        one.clockChange_ms = 1e3 * (*one.clockOffset_s - first.offset_s);
        one.clockChangeError_ms = std::hypot(*one.clockError_ms, first.error_ms);
    }
    m_firstOffsets = std::move(firstOffsets); // who comes back begins anew
    return figures;
}

void NetworkModel::refresh()
{
    std::vector<NetworkFigures> figures = measure();
    if (samePeople(figures, m_figures)) {
        m_figures = std::move(figures);
    } else {
        beginResetModel();
        m_figures = std::move(figures);
        endResetModel();
    }
    Q_EMIT measured();
}

} // namespace carina
