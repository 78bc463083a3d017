#include "apps/program/tracker_change.h"

#include "apps/program/options/site_option.h"
#include "apps/program/tracker_question.h"
#include "models/errors/error_text.h"
#include "models/text/shown_as_is.h"

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QStandardPaths>
#include <QTimer>

#include <utility>

namespace carina::program
{
namespace
{

QString changeWords(const char* text) { return QApplication::translate("TrackerChange", text); }

void showProblem(QWidget& window, const Error& error)
{
    QMessageBox box{&window};
    box.setIcon(QMessageBox::Warning);
    box.setWindowTitle(QApplication::applicationName());
    box.setText(shownAsIs(errorText(error)));
    box.addButton(QMessageBox::Close);
    box.exec();
}

QString identityOf(const std::optional<TrackerChoice>& tracker)
{
    return tracker ? trackerIdentity(*tracker) : QString{};
}

/// Where the wizard keeps its site unless it was told otherwise.
QString wizardsFolder()
{
    const QDir own{QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)};
    return QDir::cleanPath(own.filePath(QStringLiteral("../carina-registration/site.json")));
}

} // namespace

TrackerChange::TrackerChange(const Beginning& beginning)
    : m_siteOfStart{beginning.site},
      m_site{beginning.site},
      m_identity{identityOf(beginning.tracker)},
      m_isOfSite{beginning.isOfSite},
      m_conversation{beginning.conversation}
{
}

Result<SharedTools::Place> TrackerChange::placeOf(const PatientModel& patient) const
{
    return siteIn(m_site, patient, m_identity);
}

void TrackerChange::ask(QWidget& window, SharedTools& tools)
{
    const QString beside = m_site.isEmpty() ? wizardsFolder() : m_site;
    const QString kept = QFileInfo{beside}.absoluteDir().filePath(QStringLiteral("tracker.json"));
    auto chosen = askForTracker(kept.toStdString(), m_conversation, &window,
                                [&tools](bool holds) { tools.holdTracker(holds); });
    if (!chosen)
        return showProblem(window, chosen.error());
    if (!*chosen)
        return;
    QString site;
    if (m_siteOfStart.isEmpty() && !(*chosen)->isSimulated()) {
        site = QFileDialog::getOpenFileName(
            &window, changeWords("Where does the patient lie? The site of carina-registration"),
            beside, changeWords("Sites (*site*.json);;Other names (*.json)"));
        if (site.isEmpty())
            return;
    }
    use(window, tools, **std::move(chosen), site);
}

void TrackerChange::use(QWidget& window, SharedTools& tools, TrackerChoice tracker,
                        const QString& site)
{
    const QString before = m_site;
    if (m_siteOfStart.isEmpty())
        m_site = site;
    if (!give(window, tools, std::move(tracker)))
        m_site = before;
    else if (m_site != before)
        watchNow();
}

void TrackerChange::take(QWidget& window, SharedTools& tools)
{
    (void)give(window, tools, std::nullopt);
}

bool TrackerChange::give(QWidget& window, SharedTools& tools, std::optional<TrackerChoice> tracker)
{
    const QString before = std::exchange(m_identity, identityOf(tracker));
    const auto given = tools.setTracker(std::move(tracker));
    if (given) {
        m_isOfSite = false; // what a person chose stays
    } else {
        m_identity = before;
        showProblem(window, given.error());
    }
    return given.has_value();
}

void TrackerChange::watch(QObject& context, SharedTools& tools)
{
    m_context = &context;
    m_written = [this, &tools] { takeSite(tools); };
    watchNow();
    m_written(); // it may have been written since the tools were placed by it
    auto* look = new QTimer{&context};
    QObject::connect(look, &QTimer::timeout, &context, [&tools] { tools.takePlace(); });
    look->start(kLook);
}

void TrackerChange::watchNow()
{
    if (m_context)
        watchSite(m_site, *m_context, m_written);
}

void TrackerChange::takeSite(SharedTools& tools)
{
    if (!takeDevices(tools))
        tools.takePlace();
}

/// @returns whether other devices, or others of their places, were taken over, and the place with
///          them.
bool TrackerChange::takeDevices(SharedTools& tools)
{
    if (!m_isOfSite || !QFileInfo::exists(m_site))
        return false;
    auto devices = trackerOfSite(m_site.toStdString());
    if (!devices) // those of before are used on
        return false;
    if (*devices)
        (*devices)->conversation = m_conversation;
    if (areSameDevices(*devices, tools.tracker()))
        return false;
    const QString before = std::exchange(m_identity, identityOf(*devices));
    const bool isTaken =
        tools.setTracker(*std::move(devices), SharedTools::Devices::RunOn).has_value();
    if (!isTaken)
        m_identity = before;
    return isTaken;
}

ProgramTracker programTracker(SharedTools& tools, PoseRecording& recording, OfferSwitch& offer,
                              bool canBeGiven, const QString& folder)
{
    return {.sight = [&tools] { return tools.trackerSight(); },
            .recording = &recording,
            .canBeGiven = canBeGiven,
            .treatment = {tools.treatment(),
                          [&tools](const PoseTreatment& chosen) { tools.treat(chosen); }},
            .sound = KeptSound{folder},
            .offer = &offer};
}

} // namespace carina::program
