#include "models/attention/attention_model.h"

#include "models/errors/error_text.h"
#include "models/intubation/intubation_timeline.h"
#include "models/lesson/lesson_words.h"
#include "models/objects/object_words.h"
#include "models/patient/session_patient.h"
#include "models/physiology/drug_words.h"
#include "models/respiration/respiration_words.h"
#include "models/site/standing_words.h"
#include "models/station/object_tool.h"

#include <QStringList>
#include <QTimer>

#include <algorithm>
#include <tuple>
#include <utility>

namespace carina
{
namespace
{

constexpr Duration kDevelopmentsEvery = std::chrono::seconds{1};
/// Of more who fell silent only the number is told: who comes in under many names must not bury
/// everything else.
constexpr auto kMissedByName = 3;

QString nameIn(const SessionState& state, ParticipantId id)
{
    const auto found = state.participants().find(id);
    return found == state.participants().end() ? QString{}
                                               : QString::fromStdString(found->second.name);
}

/// The text after its station's name, where there are several.
QString atStation(const SessionState& state, StationId id, const QString& text)
{
    const auto open = std::ranges::count_if(state.stations(),
                                            [](const auto& entry) { return !entry.second.closed; });
    const auto found = state.stations().find(id);
    if (open < 2 || found == state.stations().end())
        return text;
    return AttentionModel::tr("%1: %2", "a station; what is the matter there")
        .arg(QString::fromStdString(found->second.name), text);
}

/// Of a tool that is missed when it is out of view: a stylus may lie anywhere.
QString toolWord(ObjectKind kind)
{
    const auto tool = trackedBy(kind);
    return tool && *tool != ToolRole::Stylus ? toolRoleName(*tool) : QString{};
}

auto urgency(const Attention& each)
{
    return std::tuple{each.concern, each.station, each.participant};
}

QString percent(double share) { return QString::number(qRound(100.0 * share)); }

/// "Pneumothorax, tension, right lung: developing, lung 88 % closed, mediastinum 6 mm aside"; once
/// the gas has closed all of the lung that it can, it only pushes on.
QString developmentText(const Development& each)
{
    const QString what = conditionText(each.condition.kind);
    const QString where = sideText(each.condition.side).toLower();
    const bool isTension = each.condition.kind == ConditionKind::TensionPneumothorax;
    if (each.isClosed)
        return AttentionModel::tr("%1, %2: lung closed but for the last %3\u00a0%, gas still comes "
                                  "in, mediastinum %4\u00a0mm aside",
                                  "disease; which lung; how much is open; how far")
            .arg(what, where, percent(1.0 - each.share),
                 QString::number(qRound(inMillimetres(each.shift))));
    if (isTension && inMillimetres(each.shift) < 1.0)
        return AttentionModel::tr("%1, %2: developing, lung %3\u00a0% closed",
                                  "disease; which lung; how much of it")
            .arg(what, where, percent(each.share));
    if (isTension)
        return AttentionModel::tr("%1, %2: developing, lung %3\u00a0% closed, mediastinum "
                                  "%4\u00a0mm aside",
                                  "disease; which lung; how much of it; how far")
            .arg(what, where, percent(each.share),
                 QString::number(qRound(inMillimetres(each.shift))));
    return AttentionModel::tr("%1, %2: developing, %3\u00a0%", "disease; which lung; how far")
        .arg(what, where, percent(each.share));
}

} // namespace

bool isSameMatter(const Attention& a, const Attention& b)
{
    return a.object == b.object && urgency(a) == urgency(b);
}

AttentionModel::AttentionModel(SessionModel& session, QObject* parent)
    : QObject{parent}, m_session{session}, m_handOver{*this, session.node()}
{
    connect(&m_session, &SessionModel::changed, this, &AttentionModel::look);
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &AttentionModel::look);
    timer->start(kAttentionLook_ms);
    look();
}

void AttentionModel::setPatient(SessionPatient& patient)
{
    m_patient = &patient;
    look();
}

void AttentionModel::setTracker(OwnTracker tracker)
{
    m_tracker = std::move(tracker);
    look();
}

void AttentionModel::look()
{
    Reports all = current();
    if (std::exchange(m_all, std::move(all)) != m_all)
        Q_EMIT changed();
}

AttentionModel::Reports AttentionModel::current()
{
    Reports all;
    const auto state = m_session.node().state();
    const auto now = m_session.node().now();
    if (m_session.phase() == SessionPhase::Ended)
        return all;
    addRefusal(all);
    addRequests(*state, all);
    addPatient(all);
    const auto sight = m_tracker ? m_tracker() : std::nullopt;
    if (sight)
        addTracker(*state, *sight, all);
    if (now) {
        addTubes(*state, *now, all);
        addPeople(*state, *now, sight.has_value(), all);
        addBrokenOff(*state, *now, all);
        addBreathing(*state, *now, all);
    }
    std::ranges::stable_sort(all, {}, urgency);
    return all;
}

void AttentionModel::addRefusal(Reports& all)
{
    const auto refusal = m_session.node().refusal();
    if (!refusal)
        m_dismissed.reset(); // the same again is news
    else if (m_dismissed != refusal)
        all.push_back(
            {.concern = Concern::Refused, .text = errorText(*refusal), .action = tr("Dismiss")});
}

bool AttentionModel::isBeingGiven(ObjectId object) const
{
    const auto pending = m_session.node().pending();
    return std::ranges::any_of(pending, [object](const FactBody& body) {
        const auto* given = std::get_if<fact::ObjectHandedOver>(&body);
        return given && given->object == object;
    });
}

void AttentionModel::addRequests(const SessionState& state, Reports& all) const
{
    for (const auto& [id, object] : state.objects()) {
        if (!state.isOpen(object.station) || isBeingGiven(id))
            continue;
        for (const ParticipantId who : object.wantedBy)
            if (who != m_session.node().self() && who != object.owner)
                all.push_back(
                    {.concern = Concern::Asked,
                     .text = atStation(state, object.station,
                                       tr("%1 asks for %2", "a person; what is to be moved")
                                           .arg(nameIn(state, who), objectWord(object))),
                     .action = tr("Give"),
                     .station = object.station,
                     .participant = who,
                     .object = id});
    }
}

bool AttentionModel::isAway(ParticipantId participant) const
{
    const auto links = m_session.node().links();
    const auto link = std::ranges::find(links, participant, &LinkReport::peer);
    return link == links.end() || link->state == LinkState::Away || link->state == LinkState::Ended;
}

bool AttentionModel::hasWrongClock(ParticipantId participant) const
{
    const auto paths = m_session.node().paths();
    const auto path = std::ranges::find(*paths, participant, &PathReport::peer);
    return path != paths->end() && path->external && path->external->isRefused;
}

/// Whether somebody has fallen silent who did not mean to leave, as far as is known, and whom
/// nobody dismissed here.
bool AttentionModel::isMissed(const Participant& who) const
{
    if (who.present || !who.fellSilent || !who.left)
        return false;
    const auto dismissed = m_notMissed.find(who.id);
    return dismissed == m_notMissed.end() || dismissed->second != *who.left;
}

/// @param hasTracker this program
void AttentionModel::addPeople(const SessionState& state, SessionTime now, bool hasTracker,
                               Reports& all)
{
    const auto add = [&](const Participant& who, Concern concern, const QString& text) {
        all.push_back(
            {.concern = concern,
             .text = atStation(state, who.station, text),
             .action = who.present || concern != Concern::Away ? tr("Show") : tr("Dismiss"),
             .station = who.station,
             .participant = who.id});
    };
    const auto missed = std::ranges::count_if(
        state.participants(), [this](const auto& entry) { return isMissed(entry.second); });
    const bool missesMany = missed > kMissedByName;
    if (missesMany)
        all.push_back(
            {.concern = Concern::Away,
             .text = tr("%1 participants are away: their programs are not heard of").arg(missed),
             .action = tr("Dismiss")});
    for (const auto& [id, who] : state.participants()) {
        const QString name = QString::fromStdString(who.name);
        if (who.tokenReplaced && now < *who.tokenReplaced + kReplacedTold)
            add(who, Concern::TwoPrograms,
                tr("Two programs had the token of %1: ask them, and remove the one that is not "
                   "theirs")
                    .arg(name));
        if (!who.present && (missesMany || !isMissed(who)))
            continue;
        const bool isSelf = id == m_session.node().self();
        if (!who.present || (!isSelf && isAway(id))) {
            add(who, Concern::Away, tr("%1 is away: their program is not heard of").arg(name));
            continue;
        }
        if (!isSelf && !who.muted) // of who is, nothing is taken
            addUnseen(state, who, now, all);
        if (who.registration && (!isSelf || hasTracker))
            if (const QString doubt = standingNotice(*who.registration); !doubt.isEmpty())
                add(who, Concern::Registration,
                    tr("%1: %2", "a participant; what is wrong").arg(name, doubt));
        if (!isSelf && hasWrongClock(id))
            add(who, Concern::Clock,
                tr("The system clock of %1's computer or of this one is wrong and is not used: "
                   "check the time service (NTP or PTP)")
                    .arg(name));
    }
}

/// Whether an object that was sent once is not seen now, for long enough to be told.
bool AttentionModel::isUnseen(ObjectId object, SessionTime now)
{
    const auto poses = m_session.node().object(object);
    const auto pose = poses ? poses->at(now) : std::nullopt;
    if (!pose || pose->validity != Validity::Lost) {
        m_unseenSince.erase(object);
        return false;
    }
    return now - m_unseenSince.try_emplace(object, now).first->second >= kUnseenTold;
}

void AttentionModel::addUnseen(const SessionState& state, const Participant& who, SessionTime now,
                               Reports& all)
{
    QStringList tools;
    for (const auto& [id, object] : state.objects())
        if (const QString word = toolWord(object.kind);
            object.owner == who.id && !word.isEmpty() && isUnseen(id, now))
            tools += word.toLower();
    if (tools.isEmpty())
        return;
    all.push_back({.concern = Concern::Unseen,
                   .text = atStation(state, who.station,
                                     tr("Out of the view of %1's tracker: %2", "person; tools")
                                         .arg(QString::fromStdString(who.name),
                                              tools.join(QStringLiteral(", ")))),
                   .action = tr("Show"),
                   .station = who.station,
                   .participant = who.id});
}

/// Others see the patient as they chose it themselves.
void AttentionModel::addBrokenOff(const SessionState& state, SessionTime now, Reports& all) const
{
    for (const auto& [id, station] : state.stations()) {
        const auto& broken = station.brokenOff;
        if (station.closed || !broken || broken->shown.by != m_session.node().self()
            || now >= broken->at + kBrokenOffTold)
            continue;
        const auto dismissed = m_notShownAgain.find(id);
        if (dismissed != m_notShownAgain.end() && dismissed->second == broken->at)
            continue;
        const QString to = nameIn(state, broken->shown.to);
        all.push_back({.concern = Concern::BrokenOff,
                       .text = atStation(state, id,
                                         tr("Shown to %1 until this program stopped: %2",
                                            "a person or everybody; what was shown")
                                             .arg(to.isEmpty() ? tr("everybody") : to,
                                                  lessonText(broken->shown.lesson, false))),
                       .action = tr("Show again"),
                       .station = id,
                       .canBeDismissed = true});
    }
}

void AttentionModel::addPatient(Reports& all) const
{
    if (m_patient && m_patient->canFetchAgain())
        all.push_back({.concern = Concern::NoPatient,
                       .text = m_patient->notice().simplified(),
                       .action = tr("Try again")});
}

/// Of the tools that were seen once, those that have not been seen for long enough to be told.
void AttentionModel::addTracker(const SessionState& state, const TrackerSight& sight,
                                Reports& all) const
{
    const ParticipantId self = m_session.node().self();
    if (!sight.trouble.isEmpty()) {
        all.push_back({.concern = Concern::Tracker,
                       .text = sight.trouble.simplified(),
                       .action = tr("Connect"),
                       .participant = self});
        return; // for which no tool is seen
    }
    QStringList tools;
    for (const ToolStatus& tool : sight.tools)
        if (!tool.isVisible && tool.age_s && *tool.age_s >= toSeconds(kUnseenTold))
            tools += tool.name.toLower();
    if (tools.isEmpty())
        return;
    all.push_back({.concern = Concern::Unseen,
                   .text = tr("Out of the view of your tracker: %1", "tools")
                               .arg(tools.join(QStringLiteral(", "))),
                   .action = tr("Show"),
                   .station = state.stationOf(self),
                   .participant = self});
}

/// Of those beyond the cords, or behind them, whose place the console does not set: what is known
/// is told where it is not the trachea, and what is not known is asked.
void AttentionModel::addTubes(const SessionState& state, SessionTime now, Reports& all)
{
    for (const auto& [id, station] : state.stations()) {
        const TubeTimeline& tube = station.respiration.tube();
        const auto last = tube.lastOfSeatAt(now);
        if (station.closed || !last || last->seat == TubeSeat::None || tube.isOverriddenAt(now))
            continue;
        const bool isKnown = last->confidence >= kLeastTold;
        if (isKnown && last->seat == TubeSeat::Trachea)
            continue;
        const QString place =
            asSureAs(tr("Tube %1", "where").arg(seatText(last->seat)), last->confidence);
        const QString text =
            isKnown
                ? place
                : tr("%1: if you see where it is, set it", "a question where a tube is").arg(place);
        all.push_back({.concern = Concern::TubePlace,
                       .text = atStation(state, id, text),
                       .action = tr("Show"),
                       .station = id});
    }
}

void AttentionModel::addBreathing(const SessionState& state, SessionTime now, Reports& all)
{
    if (!m_developmentsAt || now < *m_developmentsAt
        || now >= *m_developmentsAt + kDevelopmentsEvery) {
        m_developing = m_developments.at(state, now);
        m_developmentsAt = now;
    }
    const auto add = [&](StationId station, Concern concern, const QString& text) {
        all.push_back({.concern = concern,
                       .text = atStation(state, station, text),
                       .action = tr("Show"),
                       .station = station});
    };
    for (const Development& each : m_developing)
        add(each.station, Concern::Developing, developmentText(each));
    for (const auto& [id, station] : state.stations()) {
        const double left = station.respiration.settingsAt(now).ownBreathing;
        if (!station.closed && station.respiration.ownBreathingAt(now).stopped && left > 0.0
            && left < 1.0)
            add(id, Concern::BreathingStops,
                tr("Breathing is stopping: %1\u00a0% left").arg(percent(left)));
    }
}

void AttentionModel::act(const Attention& attention)
{
    switch (attention.concern) {
    case Concern::Refused:
        m_dismissed = m_session.node().refusal();
        break;
    case Concern::Asked:
        give(attention);
        break;
    case Concern::NoPatient:
        if (m_patient && m_patient->canFetchAgain())
            m_patient->fetchAgain();
        break;
    case Concern::Away:
        missNoLonger(attention);
        break;
    case Concern::TwoPrograms:
    case Concern::BrokenOff:
    case Concern::Unseen:
    case Concern::Tracker:
    case Concern::Registration:
    case Concern::Clock:
    case Concern::BreathingStops:
    case Concern::Developing:
    case Concern::TubePlace:
        Q_EMIT showWanted(attention);
        return;
    }
    look();
}

void AttentionModel::dismiss(const Attention& attention)
{
    const auto state = m_session.node().state();
    const auto station = state->stations().find(attention.station);
    if (attention.concern == Concern::BrokenOff && station != state->stations().end()
        && station->second.brokenOff)
        m_notShownAgain.insert_or_assign(attention.station, station->second.brokenOff->at);
    look();
}

/// One, or all. Who is in the session still is shown instead.
void AttentionModel::missNoLonger(const Attention& away)
{
    const auto state = m_session.node().state();
    const auto who = state->participants().find(away.participant);
    if (who != state->participants().end() && who->second.present) {
        Q_EMIT showWanted(away);
        return;
    }
    for (const auto& [id, participant] : state->participants())
        if (isMissed(participant) && (id == away.participant || away.participant == kNobody))
            m_notMissed.insert_or_assign(id, *participant.left);
}

void AttentionModel::give(const Attention& asked)
{
    const auto state = m_session.node().state();
    const auto object = state->objects().find(asked.object);
    if (object == state->objects().end()
        || std::ranges::find(object->second.wantedBy, asked.participant)
               == object->second.wantedBy.end())
        return;
    m_handOver.pass(object->second, asked.participant);
}

} // namespace carina
