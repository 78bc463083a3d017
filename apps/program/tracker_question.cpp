#include "apps/program/tracker_question.h"

#include "models/tracker/kept_trackers.h"
#include "ui/tracker/tracker_dialog.h"

namespace carina::program
{

Result<std::optional<TrackerChoice>> askForTracker(const std::filesystem::path& kept,
                                                   const std::string& conversation, QWidget* parent,
                                                   const HoldTracker& hold)
{
    TrackerDialog dialog{formOfKept(kept), offeredAddresses(), parent};
    if (hold)
        QObject::connect(&dialog, &TrackerDialog::devicesWanted, &dialog, hold);
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    TrackerChoice chosen = dialog.choice();
    chosen.conversation = conversation;
    if (dialog.form().source == TrackerSource::Polaris
        || dialog.form().source == TrackerSource::OpenIgtLink)
        if (const auto wrote = keepTracker(kept, std::get<TrackerDescription>(chosen.device));
            !wrote)
            return tl::unexpected(wrote.error());
    return std::optional{std::move(chosen)};
}

} // namespace carina::program
