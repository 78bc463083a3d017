#include "models/site/site_tasks.h"

#include "models/site/site_changes.h"
#include "models/site/site_standing.h"
#include "models/station/tool_status.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

constexpr std::size_t kFewestTouches = 3;
constexpr std::array kTasks{SiteStep::Tracker, SiteStep::Stylus, SiteStep::Landmarks,
                            SiteStep::Touch,   SiteStep::Fit,    SiteStep::Verify};

class TaskWords
{
    Q_DECLARE_TR_FUNCTIONS(SiteTasks)

public:
    static QString changed(StaleReason reason)
    {
        switch (reason) {
        case StaleReason::Tracker:
            return tr("Out of date: the tracker, or the frame of one of its devices, was changed "
                      "afterwards.");
        case StaleReason::Stylus:
            return tr("Out of date: the stylus was calibrated afterwards.");
        case StaleReason::Landmarks:
            return tr("Out of date: landmarks were changed afterwards.");
        case StaleReason::Manikin:
        case StaleReason::Drift:
            return tr("Out of date: the manikin was moved afterwards.");
        case StaleReason::Touches:
            return tr("Out of date: landmarks were touched again afterwards.");
        case StaleReason::Fit:
            return tr("Out of date: the patient was fitted again afterwards.");
        case StaleReason::Patient:
            return tr("Out of date: the patient was changed afterwards.");
        case StaleReason::Registering:
            return tr("The manikin is being registered again.");
        case StaleReason::Age:
            return tr("The verification is old: verify two points before a session.");
        case StaleReason::None:
            break;
        }
        return {};
    }

    static SiteTask tracker(const Site& site, const QString& tracker)
    {
        if (site.tracker.empty())
            return {};
        if (site.tracker == tracker.toStdString())
            return {.state = TaskState::Done};
        return {.state = TaskState::Stale,
                .why = tr("This site was prepared with another tracker: %1.")
                           .arg(QString::fromStdString(site.tracker))};
    }

    static SiteTask touch(const Site& site, const std::string& tool)
    {
        if (!site.stylus(tool))
            return {.state = TaskState::Waits, .why = tr("Find the tip of the stylus first.")};
        if (site.relay)
            return {.state = TaskState::Begun, .why = tr("The manikin is being registered again.")};
        const std::size_t fresh = freshTouches(site).size();
        for (const TouchedPoint& touch : site.touched)
            if (touch.stale)
                return {.state = TaskState::Stale, .why = changed(reasonOf(*touch.stale))};
        if (!site.catalogue || fresh == 0)
            return {};
        const std::size_t all = site.catalogue->landmarks.size();
        if (fresh == all)
            return {.state = TaskState::Done};
        return {.state = TaskState::Begun, .why = tr("%1 of %2 are touched.").arg(fresh).arg(all)};
    }

    static SiteTask fit(const Site& site, const RegistrationStanding& standing)
    {
        if (standing.state == RegistrationState::Stale && standing.reason != StaleReason::Age)
            return {.state = TaskState::Stale, .why = changed(standing.reason)};
        if (standing.state != RegistrationState::Missing)
            return {.state = TaskState::Done};
        if (freshTouches(site).size() < kFewestTouches)
            return {.state = TaskState::Waits, .why = tr("Touch at least three landmarks first.")};
        return {};
    }

    static SiteTask verify(const Site& site, const RegistrationStanding& standing)
    {
        switch (standing.state) {
        case RegistrationState::Missing:
            return {.state = TaskState::Waits, .why = tr("Fit the patient first.")};
        case RegistrationState::Stale:
            return {.state = TaskState::Stale, .why = changed(standing.reason)};
        case RegistrationState::NotGood:
            return {.state = TaskState::Begun,
                    .why = tr("The registration is not good enough: touch the landmarks again.")};
        case RegistrationState::Unverified:
            if (standing.reason != StaleReason::None)
                return {.state = TaskState::Stale, .why = changed(standing.reason)};
            if (!site.verification || site.verification->points.empty())
                return {};
            return {.state = TaskState::Begun, .why = tr("There is no verdict yet.")};
        case RegistrationState::Good:
        case RegistrationState::Simulated:
        case RegistrationState::NoTracker:
            break;
        }
        return {.state = TaskState::Done};
    }

    static QString registered(const Site& site, const QDateTime& today)
    {
        const SiteRegistration& registration = *site.registration;
        QString sentence = registration.madeAt.empty()
                               ? tr("Registered at an unknown time.")
                               : tr("Registered %1.").arg(howLongAgo(registration.madeAt, today));
        if (!registration.operatorName.empty())
            sentence += tr(" By %1.").arg(QString::fromStdString(registration.operatorName));
        return sentence;
    }

    /// @pre there are some.
    static QString expected(const std::vector<ExpectedError>& errors)
    {
        const ExpectedError& first = errors.front();
        const ExpectedError& worst = std::ranges::max(errors, {}, &ExpectedError::bound_mm);
        const QString sentence = tr("Expected error, in 95 of 100 cases: %1, less than %2\u00a0mm.")
                                     .arg(first.name)
                                     .arg(first.bound_mm, 0, 'f', 1);
        if (worst.name == first.name)
            return sentence + tr(" No other place is worse.");
        return sentence
               + tr(" Worst: %1, less than %2\u00a0mm.")
                     .arg(worst.name)
                     .arg(worst.bound_mm, 0, 'f', 1);
    }

    static QString staleTool(const SiteTool& tool)
    {
        const QString name = toolRoleName(tool.role);
        if (tool.isBent())
            return tr("%1: bent, or its markers were moved. Calibrate it again.").arg(name);
        if (tool.stale == StaleCause::Tracker)
            return tr("%1: the tracker, or the frame of one of its devices, was changed "
                      "afterwards. "
                      "Calibrate it again.")
                .arg(name);
        if (tool.stale)
            return tr("%1: the stylus was calibrated afterwards. Touch its tip to check it.")
                .arg(name);
        return {};
    }

    static QString oldTool(const SiteTool& tool, const QDateTime& today)
    {
        return tr("%1: calibrated or checked %2. Touch its tip to check it.")
            .arg(toolRoleName(tool.role))
            .arg(howLongAgo(tool.check ? tool.check->at : tool.calibratedAt, today));
    }

    static QString oldStylus(const StylusTip& tip, const QDateTime& today)
    {
        return tr("The stylus was calibrated %1: find its tip again before you touch landmarks "
                  "with it.")
            .arg(howLongAgo(tip.calibratedAt, today));
    }

    static QString verified(const Site& site, const QDateTime& today)
    {
        const auto& verification = site.verification;
        if (!verification || verification->verdict == Verdict::Open || verification->stale)
            return tr("The present registration is not verified: touch two points to verify it.");
        const QString when = howLongAgo(verification->at, today);
        return verification->verdict == Verdict::Good
                   ? tr("Verified %1: good.").arg(when) + beyond(*verification)
                   : tr("Verified %1: not good. Register it again.").arg(when);
    }

    /// The places beyond their own bounds: a verdict that is good judges all of them together.
    static QString beyond(const SiteVerification& verification)
    {
        QStringList names;
        for (const VerifiedPoint& point : verification.points)
            if (point.error > point.bound)
                names += tr("%1 (%2\u00a0mm)", "a place and its error")
                             .arg(QString::fromStdString(point.name))
                             .arg(inMillimetres(metres(point.error)), 0, 'f', 1);
        return names.isEmpty() ? QString{}
                               : tr(" Beyond its own 95 % bound, as one place in twenty is by "
                                    "chance: %1.")
                                     .arg(names.join(QStringLiteral(", ")));
    }

    static QString relaid(const SiteRelay& relay, const QDateTime& today)
    {
        return tr("The manikin was registered again by %1 landmarks %2.")
            .arg(relay.landmarks)
            .arg(howLongAgo(relay.at, today));
    }
};

} // namespace

SiteTask siteTask(const Site& site, SiteStep step, const std::string& tool, const QString& tracker,
                  const QDateTime& today)
{
    switch (step) {
    case SiteStep::Overview:
        return {.state = nextTask(site, tool, tracker, today) == SiteStep::Overview
                             ? TaskState::Done
                             : TaskState::Begun};
    case SiteStep::Tracker:
        return TaskWords::tracker(site, tracker);
    case SiteStep::Stylus:
        return {.state = site.stylus(tool) ? TaskState::Done : TaskState::Open};
    case SiteStep::Landmarks:
        return {.state = site.catalogue ? TaskState::Done : TaskState::Open};
    case SiteStep::Touch:
        return TaskWords::touch(site, tool);
    case SiteStep::Fit:
        return TaskWords::fit(site, siteStanding(site, {.tracker = tracker, .today = today}));
    case SiteStep::Verify:
        return TaskWords::verify(site, siteStanding(site, {.tracker = tracker, .today = today}));
    case SiteStep::Tools:
        return {.state = site.tools.empty() ? TaskState::Open : TaskState::Done};
    }
    return {};
}

QString whyStale(const SiteTool& tool) { return TaskWords::staleTool(tool); }

QString stepTitle(SiteStep step)
{
    switch (step) {
    case SiteStep::Overview:
        return TaskWords::tr("Overview");
    case SiteStep::Tracker:
        return TaskWords::tr("Tracker");
    case SiteStep::Stylus:
        return TaskWords::tr("Stylus");
    case SiteStep::Landmarks:
        return TaskWords::tr("Landmarks");
    case SiteStep::Touch:
        return TaskWords::tr("Touch");
    case SiteStep::Fit:
        return TaskWords::tr("Fit");
    case SiteStep::Verify:
        return TaskWords::tr("Verify");
    case SiteStep::Tools:
        return TaskWords::tr("Tools");
    }
    return {};
}

bool isNotGood(const Site& site)
{
    return site.verification && !site.verification->stale
           && site.verification->verdict == Verdict::NotGood;
}

SiteStep nextTask(const Site& site, const std::string& tool, const QString& tracker,
                  const QDateTime& today)
{
    for (const SiteStep step : kTasks)
        if (siteTask(site, step, tool, tracker, today).state != TaskState::Done)
            return step == SiteStep::Verify && isNotGood(site) ? SiteStep::Touch : step;
    return SiteStep::Overview;
}

QStringList siteHealth(const Site& site, const std::string& tool, const QString& tracker,
                       const QDateTime& today, const std::vector<ExpectedError>& expected)
{
    QStringList sentences;
    if (!site.registration) {
        sentences << TaskWords::tr("This manikin is not registered yet.");
    } else {
        sentences << TaskWords::registered(site, today);
        if (!expected.empty())
            sentences << TaskWords::expected(expected);
        if (!site.registration->relays.empty())
            sentences << TaskWords::relaid(site.registration->relays.back(), today);
        sentences << TaskWords::verified(site, today);
    }
    if (const StylusTip* tip = site.stylus(tool); tip && isLongAgo(tip->calibratedAt, today))
        sentences << TaskWords::oldStylus(*tip, today);
    for (const SiteStep step : kTasks)
        if (const SiteTask task = siteTask(site, step, tool, tracker, today);
            task.state == TaskState::Stale)
            sentences << QStringLiteral("%1: %2").arg(stepTitle(step), task.why);
    for (const SiteTool& each : site.tools) {
        if (const QString why = whyStale(each); !why.isEmpty())
            sentences << why;
        else if (isLongAgo(each.check ? each.check->at : each.calibratedAt, today))
            sentences << TaskWords::oldTool(each, today);
    }
    return sentences;
}

QString howLongAgo(const std::string& time, const QDateTime& today)
{
    const auto then = QDateTime::fromString(QString::fromStdString(time), Qt::ISODate);
    const qint64 days = then.isValid() ? then.daysTo(today) : 0;
    if (days <= 0)
        return TaskWords::tr("today");
    return days == 1 ? TaskWords::tr("yesterday") : TaskWords::tr("%1 days ago").arg(days);
}

} // namespace carina
