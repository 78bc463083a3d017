#include "models/tracker/device_calibration.h"

#include "engine/core/expects.h"
#include "models/errors/error_text.h"
#include "models/station/tool_status.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

/// It is not demanded, but with less the frame is known well only near one place.
constexpr Length kLeastMoved = millimetres(100.0);

BodyMotion motionIn(const BodySamples& samples) { return bodyMotion(seenPoses(samples)); }

QString degreesText(Angle angle) { return QString::number(inDegrees(angle), 'f', 1); }

QString millimetresText(Length length) { return QString::number(inMillimetres(length), 'f', 1); }

/// Why no frame was found, and what to do.
class CalibrationWords
{
    Q_DECLARE_TR_FUNCTIONS(DeviceCalibration)

public:
    static QString accepted(const FrameCalibration& found)
    {
        const double late_ms = 1e3 * toSeconds(found.place.late);
        const QString stamps =
            (late_ms < 0.0 ? tr("the second device stamps the same moment %1\u00a0ms earlier")
                           : tr("the second device stamps the same moment %1\u00a0ms later"))
                .arg(std::abs(late_ms), 0, 'f', 1);
        return tr("✓ Accepted: %1. Both agree within %2\u00a0mm and %3° (RMS), at %4 moments.")
            .arg(stamps, millimetresText(found.rms), degreesText(found.turn))
            .arg(found.pairs);
    }

    static QString contradictory(const FrameCalibration& found)
    {
        return tr("▲ Refused: both agree within %1\u00a0mm and %2° (RMS) only, and %3\u00a0mm and "
                  "%4° are the most. Fix both tools firmly to one body, keep it where both devices "
                  "see it well, and begin again.")
            .arg(millimetresText(found.rms), degreesText(found.turn), millimetresText(kWorstFit),
                 degreesText(kWorstTurn));
    }

    static QString notFound(const Error& error, const BodyMotion& first, const BodyMotion& second)
    {
        if (error.code == Errc::TooFewPoses)
            return tr("▲ Refused: both saw the body at too few moments. Keep it where both devices "
                      "see it, and begin again.");
        if (error.code != Errc::NotEnoughMotion)
            return QStringLiteral("▲ ") + errorText(error);
        if (first.turned[0] < kLeastTurnTwice && second.turned[0] < kLeastTurnTwice)
            return tr("▲ Refused: the body was turned too little. Turn it to and fro about all "
                      "axes, by 30° or so, and begin again.");
        if (first.turned[1] < kLeastTurnTwice && second.turned[1] < kLeastTurnTwice)
            return tr("▲ Refused: the body was turned about one axis only (%1° about a second one, "
                      "and %2° are due). Nod it, tilt it sideways, turn it like a key, and begin "
                      "again.")
                .arg(degreesText(std::max(first.turned[1], second.turned[1])),
                     degreesText(kLeastTurnTwice));
        return tr(
            "▲ Refused: the two tools were not turned alike. Choose two that are fixed to one "
            "body, turn it to and fro unevenly, and begin again.");
    }
};

} // namespace

DeviceCalibration::DeviceCalibration(DevicesToCalibrate devices, MakeDevice make, QObject* parent)
    : QObject{parent}, m_devices{std::move(devices)}, m_make{std::move(make)}
{
    connect(&m_timer, &QTimer::timeout, this, &DeviceCalibration::look);
}

QStringList DeviceCalibration::toolsOf(const TrackerDescription& described)
{
    QStringList names;
    for (const DescribedTool& tool : described.tools) {
        const QString name = QString::fromStdString(tool.name);
        const QString role = toolRoleName(tool.role);
        names << (role.isEmpty() || role == name ? name
                                                 : QStringLiteral("%1 (%2)").arg(name, role));
    }
    return names;
}

Result<BodyWatch> DeviceCalibration::watched(int toolOfFirst, int toolOfSecond) const
{
    const auto watcher = [this](const TrackerDescription& described, int tool) {
        return m_make(described).map([&](std::unique_ptr<Tracker> tracker) {
            return BodyWatcher{std::move(tracker), described.address,
                               described.tools.at(std::size_t(tool)).name};
        });
    };
    auto first = watcher(m_devices.first, toolOfFirst);
    if (!first)
        return tl::unexpected(first.error());
    return watcher(m_devices.second, toolOfSecond).and_then([&](BodyWatcher second) {
        return BodyWatch::begin(*std::move(first), std::move(second));
    });
}

void DeviceCalibration::begin(int toolOfFirst, int toolOfSecond)
{
    cancel();
    auto watch = watched(toolOfFirst, toolOfSecond);
    if (!watch)
        return refuse(QStringLiteral("▲ ") + errorText(watch.error()));
    m_watch = *std::move(watch);
    m_state = State::Watching;
    m_timer.start(kInterval_ms);
    look();
}

void DeviceCalibration::cancel()
{
    m_timer.stop();
    m_watch.reset();
    m_found.reset();
    m_motion = {};
    m_together = {};
    m_state = State::Idle;
    m_text.clear();
    Q_EMIT changed();
}

void DeviceCalibration::look()
{
    if (m_state != State::Watching)
        return;
    m_watch->look();
    m_motion = motionIn(m_watch->first());
    m_together = m_watch->together();
    if (m_together >= kWatched)
        return finish();
    m_text = whatToDo();
    Q_EMIT changed();
}

double DeviceCalibration::share() const
{
    return std::min(1.0, toSeconds(m_together) / toSeconds(kWatched));
}

std::array<DeviceCalibration::Coverage, 4> DeviceCalibration::coverage() const
{
    const auto turned = [this](const QString& name, std::size_t axis) {
        const double share = m_motion.turned[axis] / kLeastTurnTwice;
        return Coverage{name, tr("%1° (RMS)").arg(degreesText(m_motion.turned[axis])),
                        std::min(share, 1.0), share >= 1.0};
    };
    const double moved = m_motion.moved / kLeastMoved;
    return {turned(tr("Turned about one axis"), 0), turned(tr("Turned about a second axis"), 1),
            turned(tr("Turned about a third axis"), 2),
            Coverage{tr("Moved"), tr("%1\u00a0mm").arg(inMillimetres(m_motion.moved), 0, 'f', 0),
                     std::min(moved, 1.0), moved >= 1.0}};
}

QString DeviceCalibration::whyUnseen(const TrackerDescription& described,
                                     const BodyWatch::Sight& sight)
{
    const QString name = trackerName({described});
    if (!sight.trouble.empty())
        return tr("▲ %1: %2. The time goes on once both devices see the body.")
            .arg(name, QString::fromStdString(sight.trouble));
    return sight.isSeen
               ? QString{}
               : tr("▲ Not seen by: %1. Hold the body to where both devices see it.").arg(name);
}

QString DeviceCalibration::whatToDo() const
{
    for (const QString& unseen : {whyUnseen(m_devices.first, m_watch->firstSight()),
                                  whyUnseen(m_devices.second, m_watch->secondSight())})
        if (!unseen.isEmpty())
            return unseen;
    if (m_motion.turned[0] < kLeastTurnTwice)
        return tr("● Turn the body to and fro, and move it about.");
    if (m_motion.turned[1] < kLeastTurnTwice)
        return tr("● Turn it about other axes, too: nod it, tilt it sideways, and turn it like a "
                  "key.");
    if (m_motion.moved < kLeastMoved)
        return tr("● Move it about, too, by %1\u00a0mm or more.")
            .arg(inMillimetres(kLeastMoved), 0, 'f', 0);
    return tr("✓ It was turned and moved enough: go on until the time is over.");
}

void DeviceCalibration::finish()
{
    m_timer.stop();
    const auto body = m_watch->end();
    m_watch.reset(); // the devices are free
    if (!body)
        return refuse(QStringLiteral("▲ ") + errorText(body.error()));
    const auto found = calibrateFrames(body->first, body->second);
    if (!found)
        return refuse(CalibrationWords::notFound(found.error(), m_motion, motionIn(body->second)));
    if (!isAcceptable(*found))
        return refuse(CalibrationWords::contradictory(*found));
    m_found = *found;
    m_state = State::Accepted;
    m_text = CalibrationWords::accepted(*found);
    Q_EMIT changed();
}

void DeviceCalibration::refuse(const QString& sentence)
{
    m_state = State::Refused;
    m_text = sentence;
    Q_EMIT changed();
}

const FrameCalibration& DeviceCalibration::found() const
{
    CARINA_EXPECTS(m_state == State::Accepted);
    return *m_found;
}

} // namespace carina
