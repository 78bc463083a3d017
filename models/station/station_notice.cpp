#include "models/station/station_notice.h"

#include "models/errors/error_text.h"
#include "models/objects/object_words.h"
#include "models/site/standing_words.h"
#include "models/station/head_by_mouse.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <map>

namespace carina
{
namespace
{

/// A host says something every 250 ms; so two in a row may be lost. What others track is lost
/// sooner than the connection is given up, and not for the tracker's sake.
constexpr Duration kHostSilent = std::chrono::milliseconds{800};
/// From then on a person is not to wait for it without a choice.
constexpr Duration kHostMissed = std::chrono::seconds{5};
/// For so long it is said that a token was replaced.
constexpr Duration kTokenTold = std::chrono::minutes{1};
/// For so long it is said that an instructor moved this participant, or took from them what they
/// held.
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

/// One that cannot be reached any more is looked for on and on.
bool hostIsMissed(const SessionNode& node)
{
    const auto links = node.links();
    return std::ranges::any_of(links, [](const LinkReport& link) {
        return link.state != LinkState::Ended && link.sinceLastDatagram >= kHostMissed;
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
        return noticeWords(QT_TRANSLATE_NOOP("StationNotice",
                                             "The session has ended. To join another, press Esc"));
    case SessionPhase::Running:
        break;
    }
    return {};
}

/// Who has what was taken from a participant, after its names.
QString withdrawalText(const SessionState& state, const Withdrawal& withdrawal, const QString& what)
{
    if (withdrawal.to == kNobody)
        return noticeWords(QT_TRANSLATE_NOOP("StationNotice", "The instructor has put back: %1"))
            .arg(what);
    if (withdrawal.to == withdrawal.by)
        return noticeWords(QT_TRANSLATE_NOOP("StationNotice", "The instructor has taken over: %1"))
            .arg(what);
    return noticeWords(QT_TRANSLATE_NOOP("StationNotice", "The instructor has given to %2: %1"))
        .arg(what, participantWord(state, withdrawal.to));
}

/// What an instructor has just taken from a participant, a line for each who has it now.
QStringList withdrawals(const SessionState& state, const Participant& participant, SessionTime now)
{
    std::map<ParticipantId, QStringList> names;
    std::map<ParticipantId, Withdrawal> last;
    for (const Withdrawal& each : participant.withdrawn) {
        const auto object = state.objects().find(each.object);
        if (object == state.objects().end() || now >= each.at + kMoveTold)
            continue;
        names[each.to] << objectWord(object->second);
        last.insert_or_assign(each.to, each);
    }
    QStringList lines;
    for (const auto& [to, withdrawal] : last)
        lines << withdrawalText(state, withdrawal, names[to].join(QStringLiteral(", ")));
    return lines;
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
    lines += withdrawals(*state, self->second, now);
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

/// What to do about a tracked headset whose place is not known; empty on a screen and while it is.
QString headsetNotice(const StationMoment& moment, ViewOutput output)
{
    if (output == ViewOutput::Screen || !isLost(moment.head))
        return {};
    if (moment.head)
        return noticeWords(QT_TRANSLATE_NOOP("StationNotice", "Headset out of the tracker's view"));
    if (!moment.headIsAwaited)
        return {};
    return noticeWords(QT_TRANSLATE_NOOP(
        "StationNotice", "The tracker has not seen the headset yet: hold it in the tracker's view, "
                         "or press Esc and choose “On a screen”"));
}

/// That a headset's picture is turned by mouse, and how; empty where it is not.
QString mouseNotice(const StationMoment& moment, ViewOutput output)
{
    if (!looksByMouse(moment, output))
        return {};
    return noticeWords(QT_TRANSLATE_NOOP(
        "StationNotice", "You look around by mouse: no headset is tracked. Drag or arrow keys turn "
                         "your head, wheel or + and - bring you nearer, Home takes you back"));
}

/// That the tube of this program's participant, or of nobody, is not seen; empty while it is.
QString tubeNotice(const SessionNode& node, const StationMoment& moment, bool hasTracker)
{
    if (!isLost(moment.tube))
        return {};
    if (hasTracker && moment.worker == node.self())
        return noticeWords(QT_TRANSLATE_NOOP("StationNotice", "Tube out of the tracker's view"));
    const auto state = node.state();
    const auto self = state->participants().find(node.self());
    if (hasTracker || self == state->participants().end() || self->second.role != Role::Trainee)
        return noticeWords(QT_TRANSLATE_NOOP("StationNotice", "Nobody is at work here"));
    return noticeWords(QT_TRANSLATE_NOOP(
        "StationNotice", "No tracker is connected here: you see what others do. To take part, "
                         "press Esc and connect one under “Tracker and its tools”"));
}

/// That the host is not heard of; empty while it is.
QString hostNotice(const SessionNode& node)
{
    if (hostIsMissed(node))
        return noticeWords(QT_TRANSLATE_NOOP(
            "StationNotice", "The instructor's program does not answer. This one goes on looking "
                             "for it; to join another session, press Esc"));
    if (!hostIsHere(node))
        return noticeWords(QT_TRANSLATE_NOOP("StationNotice", "Connecting to the instructor …"));
    return {};
}

/// Of what goes on, the weightiest; empty when all is well. A pause is said beside it: it tells why
/// the patient does not move.
QString situation(const SessionNode& node, const StationMoment& moment, ViewOutput output,
                  bool hasTracker)
{
    const auto state = node.state();
    const SessionPhase phase = state->phaseAt(moment.time);
    if (phase == SessionPhase::Ended) // whether its host is there does not matter any more
        return phaseNotice(phase);
    if (const auto refusal = node.refusal())
        return errorText(*refusal);
    if (const QString host = hostNotice(node); !host.isEmpty())
        return phase == SessionPhase::Paused
                   ? QCoreApplication::translate("StationNotice", "%1. %2", "paused; no connection")
                         .arg(phaseNotice(phase), host)
                   : host;
    if (phase != SessionPhase::Running)
        return phaseNotice(phase);
    if (const QString headset = headsetNotice(moment, output); !headset.isEmpty())
        return headset;
    if (moment.worker != kNobody && moment.worker != node.self())
        return notHere(*state, moment);
    return tubeNotice(node, moment, hasTracker);
}

} // namespace

QString stationNotice(const SessionNode& node, const StationMoment& moment, ViewOutput output,
                      const std::optional<RegistrationStanding>& registration)
{
    if (isRemoved(node))
        return errorText(node.refusal().value_or(Error{Errc::Removed, {}}));
    QStringList lines{situation(node, moment, output, registration.has_value()),
                      mouseNotice(moment, output), standing(node, moment.time)};
    if (registration)
        lines.append(standingNotice(*registration));
    lines.append(drawingText(moment.tubeDrawing));
    if (isAway(moment))
        lines.append(noticeWords(QT_TRANSLATE_NOOP(
            "StationNotice", "The virtual patient was moved away from its place")));
    lines.append(liftedText(moment.lifted));
    lines.removeAll(QString{});
    return lines.join(QLatin1Char{'\n'});
}

bool isOver(const SessionNode& node)
{
    const auto now = node.now();
    return isRemoved(node) || (now && node.state()->phaseAt(*now) == SessionPhase::Ended);
}

bool offersAnother(const SessionNode& node) { return isOver(node) || hostIsMissed(node); }

bool isRemoved(const SessionNode& node)
{
    const auto links = node.links();
    return std::ranges::any_of(
        links, [](const LinkReport& link) { return link.state == LinkState::Ended; });
}

} // namespace carina
