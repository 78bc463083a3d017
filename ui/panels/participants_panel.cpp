#include "ui/panels/participants_panel.h"

#include "ui_participants_panel.h"

#include <QHeaderView>

namespace carina
{

ParticipantsPanel::ParticipantsPanel(QWidget* parent)
    : QWidget{parent}, m_ui{std::make_unique<Ui::ParticipantsPanel>()}
{
    m_ui->setupUi(this);
}

ParticipantsPanel::~ParticipantsPanel() = default;

void ParticipantsPanel::setModel(QAbstractItemModel& model)
{
    m_ui->table->setModel(&model);
    // A long name gives way, and no number.
    QHeaderView* header = m_ui->table->horizontalHeader();
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(0, QHeaderView::Stretch);
}

} // namespace carina
