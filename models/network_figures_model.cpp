#include "models/network_figures_model.h"

#include <algorithm>

namespace carina
{
namespace
{

/// The number in place of %1; or that there is none yet.
QString withUnit(const std::optional<double>& value, int decimals, const QString& words)
{
    return value ? words.arg(*value, 0, 'f', decimals) : NetworkFiguresModel::tr("not known yet");
}

/// The number, and in brackets what bounds it.
QString withBound(const std::optional<double>& value, const std::optional<double>& bound,
                  int decimals, const QString& unit)
{
    const QString words = QStringLiteral("%1") + unit;
    return NetworkFiguresModel::tr("%1 (%2)", "a figure and its bound")
        .arg(withUnit(value, decimals, words), withUnit(bound, decimals, words));
}

/// Told by shape besides the words.
QString categoryText(const ObjectFigures& object)
{
    if (!object.actions_per_s || !object.upshot_per_s)
        return NetworkFiguresModel::tr("not known yet");
    switch (categoryOf(*object.actions_per_s, *object.upshot_per_s)) {
    case ApplicationCategory::BelowUpshot:
        return NetworkFiguresModel::tr("▲ below upshot");
    case ApplicationCategory::AboveUpshot:
        return NetworkFiguresModel::tr("■ above upshot");
    }
    return {};
}

} // namespace

void NetworkFiguresModel::show(const std::optional<NetworkFigures>& figures)
{
    std::vector<Row> rows = figures ? rowsOf(*figures) : std::vector<Row>{};
    if (rows == m_rows)
        return;
    if (rows.size() == m_rows.size()) {
        m_rows = std::move(rows);
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
        return;
    }
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
}

std::vector<NetworkFiguresModel::Row> NetworkFiguresModel::rowsOf(const NetworkFigures& figures)
{
    std::vector<Row> rows;
    addPath(figures, rows);
    addClock(figures, rows);
    for (const ObjectFigures& object : figures.objects)
        addObject(object, rows);
    return rows;
}

void NetworkFiguresModel::addPath(const NetworkFigures& figures, std::vector<Row>& rows)
{
    rows.push_back({tr("Round trip"), withUnit(figures.roundTrip_ms, 2, tr("%1 ms")),
                    tr("The newest one measured")});
    rows.push_back({tr("One-way delay, mean"), withUnit(figures.meanDelay_ms, 2, tr("%1 ms")),
                    tr("Half the round trip, over the delays of the plot")});
    rows.push_back({tr("Delay, σ"), withUnit(figures.sigma_ms, 2, tr("%1 ms")),
                    tr("Standard deviation of the delays of the plot")});
    rows.push_back({tr("Probing, γ₀"), withUnit(figures.probes_per_s, 0, tr("%1 per s")),
                    tr("How often the delay needs to be measured, by how much it varies")});
    rows.push_back({tr("Lost on the way here"), withUnit(figures.loss_percent, 1, tr("%1 %")),
                    tr("Of the last 1024 datagrams")});
}

void NetworkFiguresModel::addClock(const NetworkFigures& figures, std::vector<Row>& rows)
{
    rows.push_back({tr("Clock offset"), withUnit(figures.clockOffset_s, 6, tr("%1 s")),
                    tr("The session's clock less that of the participant's computer")});
    rows.push_back({tr("Clock offset, error"), withUnit(figures.clockError_ms, 3, tr("± %1 ms")),
                    tr("Standard error")});
    rows.push_back({tr("Clock offset, at most off by"),
                    withUnit(figures.clockErrorBound_ms, 3, tr("± %1 ms")),
                    tr("Half the shortest round trip: no path makes the error larger")});
}

void NetworkFiguresModel::addObject(const ObjectFigures& object, std::vector<Row>& rows)
{
    const QString drift = tr("How far the newest sample or action moved what was drawn; in "
                             "brackets the limit, speed × delay: nobody elsewhere can know sooner");
    rows.push_back({tr("%1: drift (limit)").arg(object.name),
                    withBound(object.drift_deg, object.limit_deg, 3, tr("°")), drift});
    rows.push_back({tr("%1: drift (limit)").arg(object.name),
                    withBound(object.drift_mm, object.limit_mm, 3, tr(" mm")), drift});
    rows.push_back({tr("%1: actions vₖ (upshot v₀)").arg(object.name),
                    withBound(object.actions_per_s, object.upshot_per_s, 0, tr(" per s")),
                    tr("How often word of it comes; in brackets how often word can reach "
                       "everybody before the next: 1 / delay")});
    rows.push_back(
        {tr("%1: category").arg(object.name), categoryText(object),
         tr("Below upshot, each action is known everywhere before the next; above, actions outrun "
            "their own news")});
}

int NetworkFiguresModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int NetworkFiguresModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant NetworkFiguresModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const Row& row = m_rows[std::size_t(index.row())];
    const bool isWhat = index.column() == What;
    if (role == Qt::DisplayRole)
        return isWhat ? row.what : row.howMuch;
    if (role == Qt::ToolTipRole)
        return row.meaning;
    if (role == Qt::AccessibleTextRole)
        return isWhat ? row.what : QStringLiteral("%1: %2").arg(row.what, row.howMuch);
    if (role == Qt::TextAlignmentRole && !isWhat)
        return int{Qt::AlignRight | Qt::AlignVCenter};
    return {};
}

QVariant NetworkFiguresModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    return section == What ? tr("Figure") : tr("Value");
}

} // namespace carina
