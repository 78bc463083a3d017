#include "ui/registration/tracker_page.h"

#include "ui/registration/devices_box.h"
#include "ui/tracker/record_button.h"
#include "ui/tracker/tracker_panel.h"

#include <QFileInfo>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

namespace carina
{
namespace
{

/// Where the wizard keeps what it remembers.
QString besideSite(const RegistrationModel& registration)
{
    const QFileInfo site{QString::fromStdString(registration.siteFile().string())};
    return site.absolutePath();
}

} // namespace

TrackerPage::TrackerPage(RegistrationModel& registration, PoseRecording& recording)
    : RegistrationPage{registration}, m_devices{new DevicesBox{registration.devices(), this}}
{
    auto* another = new QPushButton{tr("Connect a&nother tracker…")};
    another->setObjectName(QStringLiteral("anotherTracker"));
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins({});
    auto* parts = new QTabWidget;
    parts->setObjectName(QStringLiteral("trackerParts"));
    parts->addTab(
        new TrackerPanel{
            [this]() -> std::optional<TrackerSight> {
                const RegistrationModel& model = this->registration();
                return TrackerSight{model.trackerTrouble(), model.tools(), model.usualVolume()};
            },
            KeptSound{besideSite(registration)}, ToolUse::Registration},
        tr("Tools that are &seen"));
    parts->addTab(m_devices, tr("Devices of this s&ite"));
    column->addWidget(parts);
    column->addWidget(new RecordButton{recording});
    column->addWidget(another);
    connect(another, &QPushButton::clicked, this, &TrackerPage::anotherWanted);
    connect(m_devices, &DevicesBox::trackWanted, this, &TrackerPage::devicesWanted);
}

void TrackerPage::refresh() { m_devices->refresh(); }

void TrackerPage::refreshLive() { m_devices->refresh(); }

QString TrackerPage::actionText() const { return tr("&Use this tracker"); }

void TrackerPage::act() { registration().useTracker(); }

} // namespace carina
