#include "ui/registration/touch_page.h"

#include "ui/registration/landmark_list.h"
#include "widgets/plain_label.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace carina
{

TouchPage::TouchPage(RegistrationModel& registration)
    : RegistrationPage{registration},
      m_list{new LandmarkList{registration, this}},
      m_keep{new QPushButton{tr("The manikin &was not moved"), this}}
{
    m_list->setObjectName(QStringLiteral("touches"));
    m_list->showColumns({LandmarkTableModel::Name, LandmarkTableModel::Touched});
    connect(m_list, &LandmarkList::chosen, this,
            [this](std::size_t landmark) { this->registration().touching().choose(landmark); });
    auto* hint = new PlainLabel{
        tr("Hold the tip still for a second, or press Page Down (or a foot switch that "
           "sends it). Choose a landmark in the list to touch it again."),
        this};
    hint->setWordWrap(true);
    m_keep->setObjectName(QStringLiteral("keep"));
    connect(m_keep, &QPushButton::clicked, this,
            [this] { this->registration().touching().cancelRelay(); });
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins({});
    column->addWidget(m_list);
    column->addWidget(hint);
    column->addWidget(m_keep);
    column->addStretch();
}

void TouchPage::refresh()
{
    m_list->refresh();
    m_keep->setVisible(registration().touching().isRelaying());
}

} // namespace carina
