#include "models/station/chin_probe_model.h"

#include "models/errors/error_text.h"

#include <QCoreApplication>

namespace carina
{
namespace
{

QString probeWords(const char* text) { return QCoreApplication::translate("ChinProbeModel", text); }

} // namespace

QString ChinProbeModel::trackerTrouble() const
{
    const std::string trouble = m_tracking ? m_tracking->trouble() : std::string{};
    return trouble.empty() ? QString{} : errorText({Errc::TrackerFailed, trouble});
}

QString ChinProbeModel::assumption() const
{
    if (!m_tracking)
        return {};
    switch (m_tracking->motionAssumption()) {
    case MotionAssumption::BodyProbe:
    case MotionAssumption::ChinMovesManikin:
        return notice();
    case MotionAssumption::ChinMovesJaw:
        return probeWords(QT_TRANSLATE_NOOP(
            "ChinProbeModel",
            "The chin probe moves the jaw: do not move the manikin or the tracker"));
    case MotionAssumption::Static:
        break;
    }
    return probeWords(
        QT_TRANSLATE_NOOP("ChinProbeModel", "Do not move the manikin or the tracker"));
}

QString ChinProbeModel::notice() const
{
    if (!m_tracking)
        return {};
    switch (m_tracking->motionAssumption()) {
    case MotionAssumption::BodyProbe:
        return probeWords(
            QT_TRANSLATE_NOOP("ChinProbeModel", "The patient follows the body probe"));
    case MotionAssumption::ChinMovesManikin:
        return probeWords(QT_TRANSLATE_NOOP(
            "ChinProbeModel",
            "The patient follows the chin probe: keep the manikin's mouth closed"));
    case MotionAssumption::ChinMovesJaw:
    case MotionAssumption::Static:
        break;
    }
    return {};
}

} // namespace carina
