#pragma once

#include "engine/io/site/site.h"
#include "models/registration/registration_targets.h"

#include <QDateTime>
#include <QString>

#include <cstdint>

namespace carina
{

enum class TaskState : std::uint8_t {
    Open,  ///< can be done now
    Waits, ///< for another task
    Begun,
    Done,
    Stale, ///< done, but something that it depends on was changed since
};

/// The state of a page's task, and one sentence on why it is not done, which may be empty.
struct SiteTask {
    TaskState state = TaskState::Open;
    QString why{};
};

/// The state of the task of a step. Overview is done when all other tasks are.
/// @param tool    the tracker's name for the stylus
/// @param tracker the name of the present tracker
/// @param today   the present time: an old verification has to be repeated
[[nodiscard]] SiteTask siteTask(const Site& site, SiteStep step, const std::string& tool,
                                const QString& tracker, const QDateTime& today);

/// One sentence: why a calibrated tube or laryngoscope is out of date; empty if it is not.
[[nodiscard]] QString whyStale(const SiteTool& tool);

/// The title of a page.
[[nodiscard]] QString stepTitle(SiteStep step);

/// Whether the verdict on the present registration is that it is not good enough.
[[nodiscard]] bool isNotGood(const Site& site);

/// The first page whose task is not done; Overview if all are, and Touch if the verdict is that the
/// registration is not good enough.
[[nodiscard]] SiteStep nextTask(const Site& site, const std::string& tool, const QString& tracker,
                                const QDateTime& today);

/// The state of the site in a few sentences: when it was registered, the expected error at the
/// first and at the worst target, what was verified, what is old or stale, and what to do.
/// @param expected of the registration at its targets, the glottis first; may be empty
[[nodiscard]] QStringList siteHealth(const Site& site, const std::string& tool,
                                     const QString& tracker, const QDateTime& today,
                                     const std::vector<ExpectedError>& expected);

/// "3 days ago", "today".
[[nodiscard]] QString howLongAgo(const std::string& time, const QDateTime& today);

} // namespace carina
