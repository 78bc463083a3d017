#include "ui/participants_panel.h"

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
    m_ui->table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_ui->table->horizontalHeader()->setStretchLastSection(true);
}

} // namespace carina
