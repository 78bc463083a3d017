#include "apps/trainee/tracker_change.h"

#include "apps/program/site_option.h"
#include "apps/program/tracker_question.h"
#include "models/errors/error_text.h"
#include "models/text/shown_as_is.h"

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QStandardPaths>

namespace carina
{
namespace
{

QString changeWords(const char* text) { return QApplication::translate("TrackerChange", text); }

void showProblem(TraineeWindow& window, const Error& error)
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

TrackerChange::TrackerChange(QString site, const std::optional<TrackerChoice>& tracker,
                             std::string conversation)
    : m_site{std::move(site)},
      m_identity{identityOf(tracker)},
      m_conversation{std::move(conversation)}
{
}

Result<TraineeStation::Place> TrackerChange::placeOf(const PatientModel& patient) const
{
    return program::siteIn(m_site, patient, m_identity);
}

void TrackerChange::ask(TraineeWindow& window, TraineeStation& station,
                        const std::function<void()>& show)
{
    const QString beside = m_site.isEmpty() ? wizardsFolder() : m_site;
    const QString kept = QFileInfo{beside}.absoluteDir().filePath(QStringLiteral("tracker.json"));
    auto chosen = program::askForTracker(kept.toStdString(), m_conversation, &window,
                                         [&station](bool holds) { station.holdTracker(holds); });
    if (!chosen)
        return showProblem(window, chosen.error());
    if (!*chosen)
        return;
    const QString siteBefore = m_site;
    if (m_site.isEmpty() && !(*chosen)->isSimulated()) {
        m_site = QFileDialog::getOpenFileName(
            &window, changeWords("Where does the patient lie? The site of carina-registration"),
            beside, changeWords("Sites (*.json)"));
        if (m_site.isEmpty())
            return;
    }
    if (!give(window, station, *std::move(chosen), show))
        m_site = siteBefore;
    else if (m_site != siteBefore)
        watchNow(window);
}

void TrackerChange::take(TraineeWindow& window, TraineeStation& station,
                         const std::function<void()>& show)
{
    (void)give(window, station, std::nullopt, show);
}

bool TrackerChange::give(TraineeWindow& window, TraineeStation& station,
                         std::optional<TrackerChoice> tracker, const std::function<void()>& show)
{
    const QString before = std::exchange(m_identity, identityOf(tracker));
    const auto given = station.setTracker(std::move(tracker), show);
    if (!given) {
        m_identity = before;
        showProblem(window, given.error());
    }
    return given.has_value();
}

void TrackerChange::watch(TraineeWindow& window, TraineeStation& station,
                          std::function<void()> show)
{
    m_written = [&station, show = std::move(show)] { station.takePlace(show); };
    watchNow(window);
}

void TrackerChange::watchNow(TraineeWindow& window)
{
    program::watchSite(m_site, window, m_written);
}

} // namespace carina
