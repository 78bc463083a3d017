#include "models/network/network_figures_model.h"

#include "engine/sync/connection/loss_window.h"

namespace carina
{
namespace
{

const QString kNoFigure = QStringLiteral("–");

QString figure(const std::optional<double>& value, int decimals)
{
    return value ? QString::number(*value, 'f', decimals) : kNoFigure;
}

QString signedFigure(double value, int decimals)
{
    const QString digits = figure(value, decimals);
    return value < 0.0 ? digits : QLatin1Char('+') + digits;
}

/// The number in place of %1; or that there is none yet.
QString withUnit(const std::optional<double>& value, int decimals, const QString& words)
{
    return value ? words.arg(*value, 0, 'f', decimals) : NetworkFiguresModel::tr("not known yet");
}

/// The number, and in brackets what bounds it.
QString withBound(const std::optional<double>& value, const std::optional<double>& bound,
                  const QString& unit)
{
    return NetworkFiguresModel::tr("%1 (%2)%3", "a figure, its bound and their unit")
        .arg(figure(value, 3), figure(bound, 3), unit);
}

QString driftText(const ObjectFigures& object)
{
    if (!object.drift_deg && !object.drift_mm)
        return NetworkFiguresModel::tr("not known yet");
    return NetworkFiguresModel::tr("%1, %2", "drift in angle and in position")
        .arg(withBound(object.drift_deg, object.limit_deg, NetworkFiguresModel::tr("°")),
             withBound(object.drift_mm, object.limit_mm, NetworkFiguresModel::tr(" mm")));
}

/// Told by shape besides the words.
QString categoryText(ApplicationCategory category)
{
    switch (category) {
    case ApplicationCategory::BelowUpshot:
        return NetworkFiguresModel::tr("✓ below upshot");
    case ApplicationCategory::AboveUpshot:
        return NetworkFiguresModel::tr("▲ above upshot");
    }
    return {};
}

QString actionsText(const ObjectFigures& object)
{
    if (!object.actions_per_s && !object.upshot_per_s)
        return NetworkFiguresModel::tr("not known yet");
    const QString rates = NetworkFiguresModel::tr("%1 (%2) per s")
                              .arg(figure(object.actions_per_s, 0), figure(object.upshot_per_s, 0));
    if (!object.actions_per_s || !object.upshot_per_s)
        return rates;
    return NetworkFiguresModel::tr("%1, %2", "actions and their category")
        .arg(rates, categoryText(categoryOf(*object.actions_per_s, *object.upshot_per_s)));
}

QString delayText(const NetworkFigures& figures)
{
    if (!figures.meanDelay_ms)
        return NetworkFiguresModel::tr("not known yet");
    return NetworkFiguresModel::tr("%1 ± %2 ms")
        .arg(figure(figures.meanDelay_ms, 2), figure(figures.sigma_ms, 2));
}

QString lossText(const std::optional<double>& loss_percent)
{
    return loss_percent
               ? NetworkFiguresModel::tr("%1 %").arg(*loss_percent, 0, 'f', 1)
               : NetworkFiguresModel::tr("not known before %1 datagrams").arg(LossWindow::kLeast);
}

QString clockText(const NetworkFigures& figures)
{
    if (!figures.clockChange_ms)
        return NetworkFiguresModel::tr("not known yet");
    return NetworkFiguresModel::tr("%1 ± %2 ms")
        .arg(signedFigure(*figures.clockChange_ms, 3), figure(figures.clockChangeError_ms, 3));
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
    rows.push_back({tr("One-way delay ± σ"), delayText(figures),
                    tr("Half the round trip: mean over the delays of the plot, and standard "
                       "deviation")});
    rows.push_back({tr("Probing, γ₀"), withUnit(figures.probes_per_s, 0, tr("%1 per s")),
                    tr("How often the delay needs to be measured, by how much it varies")});
    rows.push_back({tr("Lost on the way here"), lossText(figures.loss_percent),
                    tr("Of the last %1 datagrams, or of all so far; fewer than %2 say nothing")
                        .arg(LossWindow::kWindow)
                        .arg(LossWindow::kLeast)});
}

void NetworkFiguresModel::addClock(const NetworkFigures& figures, std::vector<Row>& rows)
{
    rows.push_back(
        {tr("Clock since joining"), clockText(figures),
         tr("By how much the session's clock has run ahead of the participant's computer since the "
            "two could first be compared, and the standard error of that. The offset itself, %1, "
            "only tells when each was switched on.")
             .arg(withUnit(figures.clockOffset_s, 6, tr("%1 s")))});
    rows.push_back({tr("Clock at most off by"),
                    withUnit(figures.clockErrorBound_ms, 3, tr("± %1 ms")),
                    tr("Half the shortest round trip: no path makes the error larger")});
}

void NetworkFiguresModel::addObject(const ObjectFigures& object, std::vector<Row>& rows)
{
    rows.push_back({tr("%1: drift (limit)").arg(object.name), driftText(object),
                    tr("How far the newest sample or action moved what was drawn, the noise of its "
                       "tracker included; in brackets the network's share, speed × delay: no other "
                       "participant can know it sooner")});
    rows.push_back({tr("%1: vₖ (v₀)").arg(object.name), actionsText(object),
                    tr("How often word of it comes; in brackets how often word can reach everybody "
                       "before the next, 1 / delay. Below upshot, each action is known everywhere "
                       "before the next; above, actions outrun their own news.")});
}

QString NetworkFiguresModel::spoken(const Row& row)
{
    QString howMuch = row.howMuch;
    for (const QChar shape : QStringLiteral("✓▲"))
        howMuch.remove(QString{shape} + QLatin1Char(' '));
    return QStringLiteral("%1: %2").arg(row.what, howMuch.replace(kNoFigure, tr("unknown")));
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
        return isWhat ? row.what : spoken(row);
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
