#include "models/registration/landmark_table_model.h"

#include "models/text/shown_as_is.h"

#include <QFont>

#include <algorithm>

namespace carina
{
namespace
{

const QString kNoResidual = QStringLiteral("–");

QString inWords_mm(double value) { return LandmarkTableModel::tr("%1 mm").arg(value, 0, 'f', 1); }

} // namespace

LandmarkTableModel::LandmarkTableModel(const RegistrationModel& registration, QObject* parent)
    : QAbstractTableModel{parent}, m_registration{registration}, m_rows{registration.landmarks()}
{
    connect(&m_registration, &RegistrationModel::changed, this, &LandmarkTableModel::refresh);
}

int LandmarkTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int LandmarkTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant LandmarkTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const LandmarkRow& row = m_rows[std::size_t(index.row())];
    if (role == Qt::DisplayRole)
        return cell(row, index.column());
    if (role == Qt::AccessibleTextRole)
        return spoken(row, index.column());
    if (role == kValueRole && index.column() == Residual && row.residual_mm)
        return *row.residual_mm;
    if (role == Qt::TextAlignmentRole && index.column() >= Residual)
        return int{Qt::AlignRight | Qt::AlignVCenter};
    if (role == Qt::FontRole && row.isNext) {
        QFont bold;
        bold.setBold(true);
        return bold;
    }
    return {};
}

QString LandmarkTableModel::cell(const LandmarkRow& row, int column)
{
    switch (column) {
    case Name:
        return row.name;
    case Touched:
        if (row.isNext)
            return tr("● now");
        if (row.isStale)
            return tr("▲ redo");
        return row.spread_mm ? tr("✓ ±%1").arg(inWords_mm(*row.spread_mm)) : tr("○ open");
    case Residual:
        return row.residual_mm ? inWords_mm(*row.residual_mm) : kNoResidual;
    case LeftOut:
        return row.leftOut_mm ? inWords_mm(*row.leftOut_mm) : kNoResidual;
    default:
        return {};
    }
}

QString LandmarkTableModel::spoken(const LandmarkRow& row, int column) const
{
    QString words = cell(row, column);
    if (column == Touched)
        words = words.section(QLatin1Char(' '), 1);
    else if (words == kNoResidual)
        words = tr("unknown");
    return headerData(column, Qt::Horizontal, Qt::DisplayRole).toString() + QStringLiteral(": ")
           + words;
}

QVariant LandmarkTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::ToolTipRole || role == Qt::WhatsThisRole
        || role == Qt::AccessibleDescriptionRole)
        return shownAsIs(explanation(section));
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Name:
        return tr("Landmark");
    case Touched:
        return tr("Touched");
    case Residual:
        return tr("Residual");
    case LeftOut:
        return tr("Left out");
    default:
        return {};
    }
}

QString LandmarkTableModel::explanation(int column)
{
    switch (column) {
    case Touched:
        return tr("Spread of the stylus tip while it was held still (±)");
    case Residual:
        return tr("Distance of the touched landmark from its place on the patient after the fit. "
                  "The RMS of all landmarks is the fiducial registration error (FRE)");
    case LeftOut:
        return tr("Leave-one-out error: distance of the landmark from its place after a fit of all "
                  "other landmarks");
    default:
        return {};
    }
}

double LandmarkTableModel::largestResidual_mm() const
{
    double largest = 0.0;
    for (const LandmarkRow& row : m_rows)
        largest = std::max(largest, row.residual_mm.value_or(0.0));
    return largest;
}

void LandmarkTableModel::refresh()
{
    std::vector<LandmarkRow> rows = m_registration.landmarks();
    if (std::ranges::equal(rows, m_rows, {}, &LandmarkRow::name, &LandmarkRow::name)) {
        m_rows = std::move(rows);
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
        return;
    }
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
}

} // namespace carina
