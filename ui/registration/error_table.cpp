#include "ui/registration/error_table.h"

#include <QHeaderView>

namespace carina
{
namespace
{

enum ErrorTableColumn { Where, Rms, Bound, Direction, ErrorTableColumnCount };
constexpr int kLeastRow = 24; ///< pixels
constexpr int kFrame = 4;     ///< pixels around the rows

} // namespace

ErrorTable::ErrorTable(QWidget* parent) : QTableWidget{0, ErrorTableColumnCount, parent}
{
    setHorizontalHeaderLabels(
        {tr("Expected error at"), tr("RMS"), tr("95 % bound"), tr("Direction")});
    explain(Rms, tr("Target registration error (TRE): root mean square of the expected distance "
                    "between the drawn anatomy and its true place there"));
    explain(Bound, tr("95 of 100 registrations have a smaller error at this target"));
    explain(Direction, tr("The direction in which the error is largest"));
    makeReadable(*this);
    setAccessibleName(tr("Expected errors"));
    setFocusPolicy(Qt::NoFocus);
}

void ErrorTable::explain(int column, const QString& explanation)
{
    for (const int role : {Qt::ToolTipRole, Qt::WhatsThisRole, Qt::AccessibleDescriptionRole})
        horizontalHeaderItem(column)->setData(role, explanation);
}

void ErrorTable::show(const std::vector<ExpectedError>& errors)
{
    setVisible(!errors.empty());
    setRowCount(int(errors.size()));
    for (int row = 0; row < rowCount(); ++row) {
        const ExpectedError& error = errors[std::size_t(row)];
        const auto put = [&](int column, const QString& text) {
            setItem(row, column, new QTableWidgetItem{text});
        };
        put(Where, error.name);
        put(Rms, tr("%1 mm").arg(error.rms_mm, 0, 'f', 1));
        put(Bound, tr("%1 mm").arg(error.bound_mm, 0, 'f', 1));
        put(Direction, error.weakest);
    }
    fitHeight(*this);
}

void makeReadable(QTableView& table)
{
    table.setEditTriggers(QAbstractItemView::NoEditTriggers);
    table.setSelectionBehavior(QAbstractItemView::SelectRows);
    table.setSelectionMode(QAbstractItemView::SingleSelection);
    table.setShowGrid(false);
    table.setTabKeyNavigation(false);
    table.setAlternatingRowColors(true);
    table.verticalHeader()->hide();
    table.verticalHeader()->setMinimumSectionSize(kLeastRow);
    table.verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table.horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table.horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    table.setWordWrap(false); // rows are as high before the table is laid out as after it
}

void fitHeight(QTableView& table)
{
    int height = table.horizontalHeader()->sizeHint().height() + kFrame;
    for (int row = 0; row < table.model()->rowCount(); ++row)
        height += table.rowHeight(row);
    table.setFixedHeight(height);
}

} // namespace carina
