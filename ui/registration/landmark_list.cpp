#include "ui/registration/landmark_list.h"

#include "ui/registration/error_table.h"
#include "widgets/residual_bar.h"

#include <QHeaderView>
#include <QShortcut>

#include <algorithm>

namespace carina
{
namespace
{

constexpr double kLeastFullScale_mm = 2.0;

} // namespace

LandmarkList::LandmarkList(const RegistrationModel& registration, QWidget* parent)
    : QTableView{parent},
      m_registration{registration},
      m_landmarks{registration},
      m_bars{new ResidualBar{tr("mm"), this}}
{
    setModel(&m_landmarks);
    setAccessibleName(tr("Landmarks"));
    setToolTip(tr("Click a landmark, or press Space on it, to choose it"));
    makeReadable(*this);
    setItemDelegateForColumn(LandmarkTableModel::Residual, m_bars);
    connect(this, &QTableView::clicked, this,
            [this](const QModelIndex& cell) { Q_EMIT chosen(std::size_t(cell.row())); });
    auto* choose = new QShortcut{Qt::Key_Space, this};
    choose->setContext(Qt::WidgetShortcut);
    connect(choose, &QShortcut::activated, this, [this] {
        if (currentIndex().isValid())
            Q_EMIT chosen(std::size_t(currentIndex().row()));
    });
}

void LandmarkList::showColumns(std::initializer_list<LandmarkTableModel::Column> columns)
{
    for (int column = 0; column < LandmarkTableModel::ColumnCount; ++column)
        setColumnHidden(column, std::ranges::count(columns, column) == 0);
}

void LandmarkList::refresh()
{
    m_bars->setFullScale(std::max(kLeastFullScale_mm, m_landmarks.largestResidual_mm()));
    if (!m_registration.nextLandmark()) // what is marked is what a click would move
        clearSelection();
    fitHeight(*this);
}

} // namespace carina
