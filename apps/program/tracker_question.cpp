#include "apps/program/tracker_question.h"

#include "apps/program/options/site_option.h"
#include "apps/program/options/tracker_option.h"
#include "models/tracker/background_work.h"
#include "models/tracker/kept_trackers.h"
#include "ui/tracker/tracker_dialog.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QProgressDialog>

#include <algorithm>

namespace carina::program
{

Result<std::optional<TrackerChoice>> askForTracker(const std::filesystem::path& kept,
                                                   const std::string& conversation, QWidget* parent,
                                                   const HoldTracker& hold)
{
    TrackerForm begin = formOfKept(kept);
    begin.conversation = QString::fromStdString(conversation);
    TrackerDialog dialog{begin, offeredAddresses(), offeredWebcams(), parent};
    dialog.offerToRecord();
    if (hold)
        QObject::connect(&dialog, &TrackerDialog::devicesWanted, &dialog, hold);
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    TrackerChoice chosen = dialog.choice();
    if (!isToBeKept(dialog.form()))
        return std::optional{std::move(chosen)};
    const auto file = keepTracker(kept, std::get<TrackerDescription>(chosen.device));
    if (!file)
        return tl::unexpected(file.error());
    if (dialog.form().source == TrackerSource::Webcam) {
        // As it is read the next time, to the last digit: it is one tracker for the site then.
        auto read = describedIn(*file);
        if (!read)
            return tl::unexpected(read.error());
        chosen.device = std::move(read->device);
    }
    return std::optional{std::move(chosen)};
}

Result<std::optional<TrackerChoice>> readTrackerOption(const QCommandLineParser& parser,
                                                       const QString& site)
{
    QProgressDialog shown{
        QCoreApplication::translate("TrackerOption", "Reading the recording named by --tracker …"),
        QCoreApplication::translate("TrackerOption", "Cancel"), 0, 100};
    std::optional<Result<std::optional<TrackerChoice>>> read; // set by the thread that reads
    BackgroundWork reading;
    QEventLoop until;
    QObject::connect(&reading, &BackgroundWork::progressed, &shown,
                     [&] { shown.setValue(std::min(reading.percent(), shown.maximum() - 1)); });
    QObject::connect(&shown, &QProgressDialog::canceled, &reading, &BackgroundWork::cancel);
    QObject::connect(&reading, &BackgroundWork::finished, &until, &QEventLoop::quit);
    shown.setValue(0); // from now on it is shown where it takes long
    reading.start([&](const Progress& goesOn) { read = trackerOption(parser, site, goesOn); });
    until.exec();
    return *std::move(read);
}

Result<std::optional<TrackerChoice>> readSessionTracker(const QCommandLineParser& parser)
{
    auto chosen = readTrackerOption(parser, siteOption(parser));
    if (chosen && *chosen && !(*chosen)->isSimulated() && siteOption(parser).isEmpty())
        return fail(Errc::WrongOption,
                    "--tracker: it needs --site, which says where the patient lies");
    return chosen;
}

} // namespace carina::program
