#pragma once

#include "engine/io/site.h"

#include <QDateTime>
#include <QString>

#include <cstdint>
#include <optional>

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

/// The first page of which the task is not done; Overview where all are.
[[nodiscard]] SiteStep nextTask(const Site& site, const std::string& tool, const QString& tracker,
                                const QDateTime& today);

/// The site in a few sentences: when it was registered, what is expected at the glottis, what was
/// verified, what is stale, and what to do. @param glottis_mm the 95 % bound there, where there is
/// one
[[nodiscard]] QStringList siteHealth(const Site& site, const std::string& tool,
                                     const QString& tracker, const QDateTime& today,
                                     const std::optional<double>& glottis_mm);

/// "3 days ago", "today".
[[nodiscard]] QString howLongAgo(const std::string& time, const QDateTime& today);

} // namespace carina
