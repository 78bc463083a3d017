#include "ui/registration/tracker_page.h"

#include <QPushButton>
#include <QVBoxLayout>

namespace carina
{

TrackerPage::TrackerPage(RegistrationModel& registration) : RegistrationPage{registration}
{
    auto* another = new QPushButton{tr("Connect a&nother tracker…")};
    another->setObjectName(QStringLiteral("anotherTracker"));
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins({});
    column->addWidget(another);
    column->addStretch();
    connect(another, &QPushButton::clicked, this, &TrackerPage::anotherWanted);
}

QString TrackerPage::actionText() const { return tr("&Use this tracker"); }

void TrackerPage::act() { registration().useTracker(); }

} // namespace carina
