#include "apps/program/tracker_question.h"

#include "ui/tracker/tracker_dialog.h"

namespace carina::program
{

Result<std::optional<TrackerChoice>> askForTracker(const std::filesystem::path& kept,
                                                   QWidget* parent)
{
    TrackerForm begin;
    std::error_code ignored;
    if (std::filesystem::exists(kept, ignored)) {
        begin.source = TrackerSource::Description;
        begin.description = QString::fromStdString(kept.string());
    }
    TrackerDialog dialog{begin, offeredAddresses(), parent};
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    if (dialog.form().source == TrackerSource::Polaris
        || dialog.form().source == TrackerSource::OpenIgtLink)
        if (const auto wrote =
                writeTrackerFile(kept, std::get<TrackerDescription>(dialog.choice().device));
            !wrote)
            return tl::unexpected(wrote.error());
    return std::optional{dialog.choice()};
}

} // namespace carina::program
