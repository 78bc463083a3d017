#include "ui/tracker/server_fields.h"

#include "models/errors/error_text.h"
#include "ui/tracker/role_box.h"
#include "widgets/plain_label.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace carina
{
namespace
{

constexpr int kServedHeight = 130;
constexpr int kServedFoundHeight = 90;
constexpr int kMostServed = 16;
enum ServedColumn { kServedName, kServedRole, kServedColumns };

} // namespace

ServerFields::ServerFields(QWidget* parent)
    : QWidget{parent},
      m_address{new QLineEdit},
      m_asked{new QComboBox},
      m_table{new QTableWidget{0, kServedColumns}},
      m_add{new QPushButton{tr("Add a t&ool")}},
      m_addSent{new QPushButton{tr("Add what the server se&nds")}},
      m_remove{new QPushButton{tr("Remo&ve tool")}},
      m_try{new QPushButton{tr("Look &what it sends")}},
      m_found{new PlainLabel}
{
    layOut();
    connect(m_address, &QLineEdit::textChanged, this, &ServerFields::edited);
    connect(m_asked, &QComboBox::currentIndexChanged, this, &ServerFields::edited);
    connect(m_table, &QTableWidget::itemChanged, this, &ServerFields::edited);
    connect(m_table, &QTableWidget::itemSelectionChanged, this, &ServerFields::refresh);
    connect(m_add, &QPushButton::clicked, this, [this] {
        add({});
        edited();
        m_table->editItem(m_table->item(m_table->rowCount() - 1, kServedName));
    });
    connect(m_addSent, &QPushButton::clicked, this, &ServerFields::addSent);
    connect(m_remove, &QPushButton::clicked, this, &ServerFields::removeChosen);
    connect(m_try, &QPushButton::clicked, this, &ServerFields::look);
    connect(&m_trial, &TrackerTrial::changed, this, &ServerFields::refresh);
    refresh();
}

void ServerFields::layOut()
{
    m_address->setObjectName(QStringLiteral("server"));
    m_address->setAccessibleName(tr("Address and port of the server"));
    m_address->setPlaceholderText(QStringLiteral("192.0.2.7:18944"));
    m_asked->setObjectName(QStringLiteral("asked"));
    m_asked->setAccessibleName(tr("How the server is asked for poses"));
    m_asked->addItem(tr("it sends them by itself, as PLUS does"), int(IgtlPoses::Transform));
    m_asked->addItem(tr("it is asked for TDATA"), int(IgtlPoses::Tdata));
    m_asked->addItem(tr("it is asked for QTDATA"), int(IgtlPoses::Qtdata));
    m_table->setObjectName(QStringLiteral("served"));
    m_table->setAccessibleName(tr("Tools of the server"));
    m_table->setHorizontalHeaderLabels({tr("Name at the server"), tr("Role")});
    m_table->horizontalHeader()->setSectionResizeMode(kServedName, QHeaderView::Stretch);
    m_table->verticalHeader()->hide();
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setTabKeyNavigation(false);
    m_table->setFixedHeight(kServedHeight);
    m_try->setObjectName(QStringLiteral("look"));
    m_try->setAutoDefault(false);
    m_found->setObjectName(QStringLiteral("sent"));
    m_found->setAccessibleName(tr("What the server sends"));
    m_found->setTextFormat(Qt::PlainText);
    m_found->setWordWrap(true);
    m_found->setMinimumHeight(kServedFoundHeight);
    m_found->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* form = new QFormLayout{this};
    form->addRow(tr("A&ddress"), m_address);
    form->addRow(tr("Pos&es"), m_asked);
    form->addRow(tr("Tools"), toolsWithButtons());
    form->addRow(m_try, m_found);
}

QWidget* ServerFields::toolsWithButtons()
{
    m_add->setObjectName(QStringLiteral("addServed"));
    m_addSent->setObjectName(QStringLiteral("addSent"));
    m_remove->setObjectName(QStringLiteral("removeServed"));
    auto* row = new QHBoxLayout;
    for (QPushButton* button : {m_addSent, m_add, m_remove}) {
        button->setAutoDefault(false);
        row->addWidget(button);
    }
    row->addStretch();
    auto* all = new QWidget;
    auto* column = new QVBoxLayout{all};
    column->setContentsMargins({});
    column->addWidget(m_table);
    column->addLayout(row);
    return all;
}

void ServerFields::fill(const TrackerForm& form)
{
    m_address->setText(form.server);
    m_asked->setCurrentIndex(m_asked->findData(int(form.asked)));
    m_table->setRowCount(0);
    for (const ServedTool& tool : form.served)
        add(tool);
    refresh();
}

void ServerFields::read(TrackerForm& form) const
{
    form.server = m_address->text();
    form.asked = static_cast<IgtlPoses>(m_asked->currentData().toInt());
    form.served = tools();
}

std::vector<ServedTool> ServerFields::tools() const
{
    std::vector<ServedTool> tools;
    for (int row = 0; row < m_table->rowCount(); ++row)
        tools.push_back({m_table->item(row, kServedName)->text(),
                         chosenRole(*m_table->cellWidget(row, kServedRole))});
    return tools;
}

void ServerFields::add(const ServedTool& tool)
{
    const QSignalBlocker silent{m_table};
    const int row = m_table->rowCount();
    m_table->insertRow(row);
    m_table->setItem(row, kServedName, new QTableWidgetItem{tool.device});
    QComboBox* role = roleBox(tool.role, tr("Role of tool %1").arg(row + 1));
    connect(role, &QComboBox::currentIndexChanged, this, &ServerFields::edited);
    m_table->setCellWidget(row, kServedRole, role);
    m_table->resizeColumnToContents(kServedRole);
    m_table->selectRow(row);
}

/// The tools that come and are not yet there. What is seen of them is then looked at.
void ServerFields::addSent()
{
    std::vector<ServedTool> there = tools();
    for (const QString& name : m_trial.sentTools()) {
        if (m_table->rowCount() == kMostServed
            || std::ranges::count(there, name, &ServedTool::device) > 0)
            continue;
        there.push_back({name, freeRoleOf(name, there)});
        add(there.back());
    }
    edited();
    look();
}

void ServerFields::removeChosen()
{
    if (m_table->currentRow() < 0)
        return;
    m_table->removeRow(m_table->currentRow());
    edited();
}

void ServerFields::look()
{
    TrackerForm form{.source = TrackerSource::OpenIgtLink};
    read(form);
    if (const auto begun = m_trial.begin(describedServer(form)); !begun)
        m_found->setText(errorText(begun.error()));
}

void ServerFields::endTrial() { m_trial.end(); }

/// What was found is not of these fields any more.
void ServerFields::edited()
{
    m_trial.end();
    Q_EMIT changed();
}

void ServerFields::refresh()
{
    m_found->setText(m_trial.text());
    m_try->setEnabled(isServerAddress(m_address->text()));
    const QStringList sent = m_trial.sentTools();
    const std::vector<ServedTool> there = tools();
    m_addSent->setEnabled(std::ranges::any_of(sent, [&](const QString& name) {
        return std::ranges::count(there, name, &ServedTool::device) == 0;
    }));
    m_add->setEnabled(m_table->rowCount() < kMostServed);
    m_remove->setEnabled(m_table->currentRow() >= 0);
}

} // namespace carina
