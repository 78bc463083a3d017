#include "models/network/network_figures_model.h"

#include "engine/sync/connection/loss_window.h"
#include "models/text/shown_as_is.h"

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
    const QString angle =
        withBound(object.drift_deg, object.limit_deg, NetworkFiguresModel::tr("°"));
    const QString position =
        withBound(object.drift_mm, object.limit_mm, NetworkFiguresModel::tr(" mm"));
    if (!object.drift_percent)
        return NetworkFiguresModel::tr("%1, %2", "drift in angle and in position")
            .arg(angle, position);
    return NetworkFiguresModel::tr("%1, %2, %3", "drift in angle, in position and in size")
        .arg(angle, position,
             withBound(object.drift_percent, object.limit_percent, NetworkFiguresModel::tr(" %")));
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

QString actionsText(const NetworkFigures& figures)
{
    if (!figures.actions_per_s && !figures.upshot_per_s)
        return NetworkFiguresModel::tr("not known yet");
    const QString rates =
        NetworkFiguresModel::tr("%1 (%2) per s")
            .arg(figure(figures.actions_per_s, 1), figure(figures.upshot_per_s, 0));
    if (!figures.actions_per_s || !figures.upshot_per_s)
        return rates;
    return NetworkFiguresModel::tr("%1, %2", "actions and their category")
        .arg(rates, categoryText(categoryOf(*figures.actions_per_s, *figures.upshot_per_s)));
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

/// Told by shape besides the words.
QString externalText(const ExternalVerdict& external)
{
    const QString apart = NetworkFiguresModel::tr("%1 ± %2 ms")
                              .arg(signedFigure(1e3 * toSeconds(external.difference), 3),
                                   figure(1e3 * toSeconds(external.error), 3));
    return external.isRefused ? NetworkFiguresModel::tr("▲ refused, %1").arg(apart)
                              : NetworkFiguresModel::tr("✓ used, %1").arg(apart);
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
    if (figures.isOwn) {
        addActions(figures, rows);
        return rows;
    }
    addDelay(figures, rows);
    for (const ObjectFigures& object : figures.objects)
        addObject(object, rows);
    addProbes(figures, rows);
    if (figures.traffic)
        addTraffic(*figures.traffic, rows);
    addActions(figures, rows);
    addClock(figures, rows);
    return rows;
}

QString NetworkFiguresModel::proberOf(const NetworkFigures& figures)
{
    return figures.isOfStrategy
               ? tr("Measured by the probes of the session's strategy (ASA), which goes by it")
               : tr("Measured by the probes of the session clock");
}

void NetworkFiguresModel::addDelay(const NetworkFigures& figures, std::vector<Row>& rows)
{
    rows.push_back(
        {tr("Round-trip time"), withUnit(figures.roundTrip_ms, 2, tr("%1 ms")),
         tr("Time that a datagram takes to the participant and back; the newest measurement")});
    rows.push_back({tr("One-way delay ± σ"), delayText(figures),
                    tr("Latency: half the round-trip time. Mean, and standard deviation (jitter), "
                       "of the delays in the plot. %1.")
                        .arg(proberOf(figures))});
}

void NetworkFiguresModel::addProbes(const NetworkFigures& figures, std::vector<Row>& rows)
{
    rows.push_back(
        {figures.isOfStrategy ? tr("ASA's probe rate, γ₀") : tr("Clock's probe rate, γ₀"),
         withUnit(figures.probes_per_s, 0, tr("%1 per s")),
         tr("How often the delay has to be measured: more often, the more it varies. %1.")
             .arg(proberOf(figures))});
    rows.push_back({tr("Datagram loss"), lossText(figures.loss_percent),
                    tr("Share of the participant's last %1 datagrams that did not arrive; not "
                       "known for fewer than %2")
                        .arg(LossWindow::kWindow)
                        .arg(LossWindow::kLeast)});
}

void NetworkFiguresModel::addTraffic(const TrafficReport& traffic, std::vector<Row>& rows)
{
    rows.push_back(
        {tr("Received"),
         tr("%1 kB/s, %2 samples per s")
             .arg(1e-3 * traffic.bytesPerSecond, 0, 'f', 1)
             .arg(traffic.samplesPerSecond, 0, 'f', 0),
         tr("What the participant's program sends to this one: bytes without encryption "
            "and headers of the network, and poses of its objects; of the last seconds")});
    rows.push_back({tr("Changes made"), QString::number(traffic.facts),
                    tr("Changes of the session that the participant made since joining")});
    rows.push_back({tr("Refused"), QString::number(traffic.refused),
                    tr("What was not taken from the participant since joining: changes, poses and "
                       "datagrams beyond what their role may send, or sent while muted")});
}

void NetworkFiguresModel::addActions(const NetworkFigures& figures, std::vector<Row>& rows)
{
    rows.push_back(
        {tr("Actions, vₖ (v₀)"), actionsText(figures),
         tr("Action frequency vₖ: how often the participant acts on a shared object, on average "
            "over all of them; in brackets the upshot frequency v₀ = 1 / delay. Below upshot "
            "(vₖ < v₀) each action has reached all participants before the next begins; above, it "
            "has not.")});
}

void NetworkFiguresModel::addClock(const NetworkFigures& figures, std::vector<Row>& rows)
{
    rows.push_back({tr("Clock drift since joining"), clockText(figures),
                    tr("Change of the offset between the session clock and the clock of the "
                       "participant's computer since the first measurement, and its standard "
                       "error. The offset itself, %1, follows from when each computer was started.")
                        .arg(withUnit(figures.clockOffset_s, 6, tr("%1 s")))});
    rows.push_back({tr("Clock error at most"),
                    withUnit(figures.clockErrorBound_ms, 3, tr("± %1 ms")),
                    tr("Upper bound of the error of the clock offset: half the shortest round-trip "
                       "time, for any asymmetry of the path, and what clocks set by a time service "
                       "moved it by")});
    if (figures.external)
        rows.push_back(
            {tr("Clocks set by NTP or PTP"), externalText(*figures.external),
             tr("The clock offset as the system clocks of both computers give it, which a time "
                "service (NTP or PTP) keeps right, minus the offset from the round trips; with its "
                "standard error. If the two agree, the system clocks correct the round trips, "
                "which cannot show that a path is longer in one direction. If they do not agree, "
                "one of the two system clocks is wrong and neither is used: check the time service "
                "of both computers.")});
}

void NetworkFiguresModel::addObject(const ObjectFigures& object, std::vector<Row>& rows)
{
    rows.push_back(
        {tr("%1: drift (limit)").arg(object.name), driftText(object),
         tr("Drift: difference between what this program and its owner's showed at the same "
            "session "
            "time, with the noise of the tracker. In brackets the part that the network delay "
            "makes "
            "unavoidable, speed × delay, for a viewer that goes on with the old motion until it "
            "hears of the new one; one that guesses better can be below. For an object that moves "
            "by itself that is 0 once its last action has arrived. Neither has what the two "
            "clocks cannot see, the asymmetry of the path: speed × the bound of the clock at "
            "most")});
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
        return shownAsIs(row.meaning);
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
    return section == What ? tr("Quantity") : tr("Value");
}

} // namespace carina
