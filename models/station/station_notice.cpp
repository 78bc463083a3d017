#include "models/station/station_notice.h"

#include "models/errors/error_text.h"
#include "models/objects/object_words.h"
#include "models/site/standing_words.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace carina
{
namespace
{

/// A host says something every 250 ms; so two in a row may be lost. What others track is lost
/// sooner than the connection is given up, and not for the tracker's sake.
constexpr Duration kHostSilent = std::chrono::milliseconds{800};
/// For so long it is said that a token was replaced.
constexpr Duration kTokenTold = std::chrono::minutes{1};
/// For so long it is said that an instructor moved this participant.
constexpr Duration kMoveTold = std::chrono::seconds{15};

QString noticeWords(const char* text) { return QCoreApplication::translate("StationNotice", text); }

bool isLost(const std::optional<PoseSample>& sample)
{
    return !sample || sample->validity == Validity::Lost;
}

bool hostIsHere(const SessionNode& node)
{
    const auto links = node.links();
    return std::ranges::any_of(links, [](const LinkReport& link) {
        return link.state == LinkState::Connected && link.sinceLastDatagram < kHostSilent;
    });
}

QString phaseNotice(SessionPhase phase)
{
    switch (phase) {
    case SessionPhase::Prepared:
        return noticeWords(
            QT_TRANSLATE_NOOP("StationNotice", "Waiting for the instructor to start"));
    case SessionPhase::Paused:
        return noticeWords(QT_TRANSLATE_NOOP("StationNotice", "Paused"));
    case SessionPhase::Ended:
        return noticeWords(QT_TRANSLATE_NOOP("StationNotice", "The session has ended"));
    case SessionPhase::Running:
        break;
    }
    return {};
}

/// What was decided about this program's participant; empty where nothing was.
QString standing(const SessionNode& node, SessionTime now)
{
    const auto state = node.state();
    const auto self = state->participants().find(node.self());
    if (self == state->participants().end())
        return {};
    const auto refusal = node.refusal();
    const bool isTold = refusal && refusal->code == Errc::Muted;
    QStringList lines;
    if (self->second.muted && !isTold)
        lines.append(errorText({Errc::Muted, {}}));
    if (const auto& at = self->second.tokenReplaced; at && now < *at + kTokenTold)
        lines.append(noticeWords(QT_TRANSLATE_NOOP(
            "StationNotice", "Another program was here with your name and token. It had to leave, "
                             "and this one has a new token. If that was not you, tell the "
                             "instructor.")));
    const auto station = state->stations().find(self->second.station);
    if (const auto& at = self->second.moved;
        at && now < *at + kMoveTold && station != state->stations().end())
        lines.append(noticeWords(QT_TRANSLATE_NOOP("StationNotice",
                                                   "The instructor has moved you to the station "
                                                   "“%1”"))
                         .arg(QString::fromStdString(station->second.name)));
    return lines.join(QLatin1Char{'\n'});
}

/// That the tube of another, who is at work, is not seen; empty while it is.
QString notHere(const SessionState& state, const StationMoment& moment)
{
    const auto worker = state.participants().find(moment.worker);
    if (!isLost(moment.tube) || worker == state.participants().end())
        return {};
    return noticeWords(QT_TRANSLATE_NOOP("StationNotice", "The tube of %1 is out of view"))
        .arg(QString::fromStdString(worker->second.name));
}

/// Of what goes on, the weightiest; empty when all is well.
QString situation(const SessionNode& node, const StationMoment& moment, ViewOutput output)
{
    if (const auto refusal = node.refusal())
        return errorText(*refusal);
    if (!hostIsHere(node))
        return noticeWords(QT_TRANSLATE_NOOP("StationNotice", "Connecting to the instructor …"));
    const auto state = node.state();
    const QString phase = phaseNotice(state->phaseAt(moment.time));
    if (!phase.isEmpty())
        return phase;
    if (output != ViewOutput::Screen && isLost(moment.head))
        return noticeWords(QT_TRANSLATE_NOOP("StationNotice", "Headset out of the tracker's view"));
    if (moment.worker != kNobody && moment.worker != node.self())
        return notHere(*state, moment);
    if (isLost(moment.tube))
        return noticeWords(QT_TRANSLATE_NOOP("StationNotice", "Tube out of the tracker's view"));
    return {};
}

} // namespace

QString stationNotice(const SessionNode& node, const StationMoment& moment, ViewOutput output,
                      const std::optional<RegistrationStanding>& registration)
{
    if (isRemoved(node))
        return errorText(node.refusal().value_or(Error{Errc::Removed, {}}));
    QStringList lines{situation(node, moment, output), standing(node, moment.time)};
    if (registration)
        lines.append(standingNotice(*registration));
    if (isAway(moment))
        lines.append(noticeWords(QT_TRANSLATE_NOOP(
            "StationNotice", "The virtual patient was moved away from its place")));
    lines.append(liftedText(moment.lifted));
    lines.removeAll(QString{});
    return lines.join(QLatin1Char{'\n'});
}

bool isRemoved(const SessionNode& node)
{
    const auto links = node.links();
    return std::ranges::any_of(
        links, [](const LinkReport& link) { return link.state == LinkState::Ended; });
}

} // namespace carina
