#include "ui/tracker/tracker_tools.h"

#include "models/text/shown_as_is.h"
#include "ui/tracker/role_box.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace carina
{
namespace
{

constexpr int kTableHeight = 130;
constexpr int kMostTools = 9;
enum Column { kRoleColumn, kDefinitionColumn, kColumns };

} // namespace

TrackerTools::TrackerTools(QWidget* parent)
    : QWidget{parent},
      m_table{new QTableWidget{0, kColumns}},
      m_addPluggedIn{new QPushButton{tr("Add a plu&gged-in tool")}},
      m_remove{new QPushButton{tr("Re&move tool")}}
{
    m_table->setObjectName(QStringLiteral("tools"));
    m_table->setAccessibleName(tr("Tools of the tracker"));
    m_table->setHorizontalHeaderLabels({tr("Role"), tr("Definition")});
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->verticalHeader()->hide();
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setTabKeyNavigation(false);
    m_table->setFixedHeight(kTableHeight);
    m_addPluggedIn->setObjectName(QStringLiteral("addPluggedIn"));
    m_remove->setObjectName(QStringLiteral("removeTool"));
    auto* addDefinition = new QPushButton{tr("Add a tool's &definition…")};
    addDefinition->setObjectName(QStringLiteral("addDefinition"));
    auto* row = new QHBoxLayout;
    for (QPushButton* button : {m_addPluggedIn, addDefinition, m_remove}) {
        button->setAutoDefault(false);
        row->addWidget(button);
    }
    row->addStretch();
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins({});
    column->addWidget(m_table);
    column->addLayout(row);
    connect(m_addPluggedIn, &QPushButton::clicked, this, &TrackerTools::addPluggedIn);
    connect(addDefinition, &QPushButton::clicked, this, &TrackerTools::askForDefinitions);
    connect(m_remove, &QPushButton::clicked, this, &TrackerTools::removeChosen);
    connect(m_table, &QTableWidget::itemSelectionChanged, this, &TrackerTools::refreshButtons);
    refreshButtons();
}

std::vector<FormTool> TrackerTools::tools() const
{
    std::vector<FormTool> tools;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        tools.push_back({chosenRole(*m_table->cellWidget(row, kRoleColumn)),
                         m_table->item(row, kDefinitionColumn)->data(Qt::UserRole).toString()});
    }
    return tools;
}

void TrackerTools::setTools(const std::vector<FormTool>& tools)
{
    m_table->setRowCount(0);
    for (const FormTool& tool : tools)
        add(tool);
}

void TrackerTools::add(FormTool tool)
{
    const int row = m_table->rowCount();
    m_table->insertRow(row);
    QComboBox* role = roleBox(tool.role, tr("Role of tool %1").arg(row + 1));
    connect(role, &QComboBox::currentIndexChanged, this, &TrackerTools::changed);
    m_table->setCellWidget(row, kRoleColumn, role);
    auto* definition =
        new QTableWidgetItem{tool.definition.isEmpty() ? tr("plugged into the tracker")
                                                       : QFileInfo{tool.definition}.fileName()};
    definition->setData(Qt::UserRole, tool.definition);
    definition->setToolTip(shownAsIs(tool.definition));
    m_table->setItem(row, kDefinitionColumn, definition);
    m_table->resizeColumnToContents(kRoleColumn);
    m_table->selectRow(row);
    refreshButtons();
    Q_EMIT changed();
}

void TrackerTools::addPluggedIn() { add({freeRole(), {}}); }

void TrackerTools::addDefinition(const QString& file) { add({freeRole(), file}); }

void TrackerTools::askForDefinitions()
{
    for (const QString& file :
         QFileDialog::getOpenFileNames(this, tr("Definitions of wireless tools"), {},
                                       tr("Tool definitions of NDI (*.rom *.ROM)")))
        if (m_table->rowCount() < kMostTools)
            addDefinition(file);
}

void TrackerTools::removeChosen()
{
    if (m_table->currentRow() < 0)
        return;
    m_table->removeRow(m_table->currentRow());
    refreshButtons();
    Q_EMIT changed();
}

void TrackerTools::refreshButtons()
{
    m_addPluggedIn->setEnabled(m_table->rowCount() < kMostTools);
    m_remove->setEnabled(m_table->currentRow() >= 0);
}

ToolRole TrackerTools::freeRole() const
{
    const std::vector<FormTool> taken = tools();
    const auto roles = offeredRoles();
    const auto free = std::ranges::find_if(roles, [&](ToolRole role) {
        return std::ranges::count(taken, role, &FormTool::role) == 0;
    });
    return free == roles.end() ? ToolRole::Other : *free;
}

} // namespace carina
