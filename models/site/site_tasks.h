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
    Stale, ///< done, and something beneath it has changed since
};

/// How far a page's task is, and why it is no further: a sentence, empty where there is nothing to
/// say.
struct SiteTask {
    TaskState state = TaskState::Open;
    QString why{};
};

/// What of a site is done, stale or missing. Overview is done when everything is.
/// @param tool    the stylus in hand, as its tracker names it
/// @param tracker the tracker that is there, in words
/// @param today   when this is asked: what was verified long ago is to be verified again
[[nodiscard]] SiteTask siteTask(const Site& site, SiteStep step, const std::string& tool,
                                const QString& tracker, const QDateTime& today);

/// The title of a page.
[[nodiscard]] QString stepTitle(SiteStep step);

/// Whether a verdict says that this registration is not good enough.
[[nodiscard]] bool isNotGood(const Site& site);

/// The first page of which the task is not done; Overview where all are, and Touch after a verdict
/// that the registration is not good enough.
[[nodiscard]] SiteStep nextTask(const Site& site, const std::string& tool, const QString& tracker,
                                const QDateTime& today);

/// The site in a few sentences: when it was registered, what error is expected first and where it
/// is worst, what was verified, what is old or stale, and what to do.
/// @param expected of the registration at its targets, the glottis first; may be empty
[[nodiscard]] QStringList siteHealth(const Site& site, const std::string& tool,
                                     const QString& tracker, const QDateTime& today,
                                     const std::vector<ExpectedError>& expected);

/// "3 days ago", "today".
[[nodiscard]] QString howLongAgo(const std::string& time, const QDateTime& today);

} // namespace carina
