#include "models/lesson/lesson_model.h"

#include "models/lesson/lesson_words.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

/// What is proposed and not decided yet would be proposed twice.
bool isUnderWay(const SessionNode& node)
{
    return std::ranges::any_of(node.pending(), [](const FactBody& body) {
        return std::holds_alternative<fact::LessonShown>(body)
               || std::holds_alternative<fact::LessonEnded>(body);
    });
}

/// What rests is where it was set last: its samples go on by the node's thread, however seldom the
/// picture of this program is drawn.
PoseSource resting(std::shared_ptr<SharedPose> pose, const SessionNode& node)
{
    return [pose = std::move(pose), &node]() -> std::optional<PoseSample> {
        auto sample = pose->newest();
        const auto now = node.now();
        if (sample && now)
            sample->time = std::max(sample->time, *now);
        return sample;
    };
}

bool canBeShown(const Participant& who, StationId station)
{
    return who.present && who.station == station && who.role != Role::Instructor;
}

} // namespace

LessonModel::LessonModel(SessionModel& session, StationId station, QObject* parent)
    : QObject{parent}, m_session{session}, m_station{station}
{
    connect(&m_session, &SessionModel::changed, this, [this] {
        if (!isOn())
            withdraw(); // it was ended otherwise than by this
        Q_EMIT changed();
    });
}

void LessonModel::setStation(StationId station)
{
    if (station == m_station)
        return;
    m_left.insert_or_assign(m_station, Left{setting(), m_picture, patientAt(m_station)});
    withdraw(); // what is looked at is elsewhere
    m_station = station;
    m_target = kNobody;
    m_picture = {};
    comeBack();
    Q_EMIT changed();
}

/// To where something was left, if it was.
void LessonModel::comeBack()
{
    const auto found = m_left.find(m_station);
    if (found == m_left.end())
        return;
    const Left left = found->second;
    m_target = left.setting.to;
    m_showsView = left.setting.showsView;
    if (left.patient != patientAt(m_station))
        return; // the parts were those of another patient
    m_picture = left.picture;
    if (left.setting.on && hasEndedByGoing(left.setting))
        apply(left.setting);
}

/// Whether it was on at this station, and is not because this person went to another one, as with
/// tools that are shared where they are. Who is to see it has to be here still.
bool LessonModel::hasEndedByGoing(const Setting& left) const
{
    const auto state = m_session.node().state();
    const auto station = state->stations().find(m_station);
    const bool isFree = station != state->stations().end() && !station->second.closed
                        && !station->second.lesson && !station->second.brokenOff;
    return isFree && ownStation(m_session.node()) != m_station && target() == left.to;
}

std::string LessonModel::patientAt(StationId station) const
{
    const auto state = m_session.node().state();
    const auto found = state->stations().find(station);
    return found == state->stations().end() ? std::string{} : found->second.anatomyHash;
}

std::vector<LessonModel::Target> LessonModel::targets() const
{
    std::vector<Target> all{{kNobody, tr("Everybody here")}};
    const auto state = m_session.node().state();
    for (const auto& [id, who] : state->participants())
        if (canBeShown(who, m_station))
            all.push_back({id, QString::fromStdString(who.name)});
    return all;
}

ParticipantId LessonModel::target() const
{
    const auto state = m_session.node().state();
    if (const ShownLesson* lesson = shown(*state, m_station))
        return lesson->to;
    const auto who = state->participants().find(m_target);
    return who != state->participants().end() && canBeShown(who->second, m_station) ? m_target
                                                                                    : kNobody;
}

/// By this person.
const ShownLesson* LessonModel::shown(const SessionState& state, StationId station) const
{
    const auto found = state.stations().find(station);
    const bool isOwn = found != state.stations().end() && found->second.lesson
                       && found->second.lesson->by == m_session.node().self();
    return isOwn ? &*found->second.lesson : nullptr;
}

bool LessonModel::isOn() const { return shown(*m_session.node().state(), m_station) != nullptr; }

bool LessonModel::canSwitch() const
{
    const auto state = m_session.node().state();
    return state->isOpen(m_station) && state->stationOf(m_session.node().self()) != kNoStation;
}

LessonModel::Setting LessonModel::setting() const { return {isOn(), target(), m_showsView}; }

void LessonModel::setOn(bool on)
{
    Setting wanted = setting();
    wanted.on = on;
    change(wanted);
}

void LessonModel::setTarget(ParticipantId target)
{
    Setting wanted = setting();
    wanted.to = target;
    change(wanted);
}

void LessonModel::setShowsView(bool shows)
{
    Setting wanted = setting();
    wanted.showsView = shows;
    change(wanted);
}

std::optional<ShownLesson> LessonModel::brokenOff() const
{
    const auto state = m_session.node().state();
    const auto station = state->stations().find(m_station);
    if (station == state->stations().end() || !station->second.brokenOff
        || station->second.brokenOff->shown.by != m_session.node().self())
        return std::nullopt;
    return station->second.brokenOff->shown;
}

bool LessonModel::canShowAgain() const
{
    return brokenOff() && canSwitch() && !isUnderWay(m_session.node());
}

void LessonModel::showAgain()
{
    const auto before = brokenOff();
    if (!before || !canShowAgain())
        return;
    m_picture = before->lesson;
    change({true, before->to, before->lesson.showsView});
}

/// What nobody sees, because nothing is shown before or after, is nothing to be undone.
void LessonModel::change(const Setting& wanted)
{
    const Setting before = setting();
    if (m_history && (before.on || wanted.on))
        m_history->add(
            *this, changeText(wanted),
            [this, station = m_station, before] { takeBack(station, before); }, 0, m_station);
    apply(wanted);
}

/// At a station that this does not speak of, something is shown only while this person is there:
/// else once they come back.
void LessonModel::takeBack(StationId station, const Setting& before)
{
    if (station == m_station)
        return apply(before);
    const auto left = m_left.find(station);
    if (left == m_left.end())
        return;
    SessionNode& node = m_session.node();
    left->second.setting = before;
    if (!before.on && shown(*node.state(), station))
        node.propose(station, fact::LessonEnded{});
    if (before.on && ownStation(node) == station && left->second.patient == patientAt(station))
        show(station, before, left->second.picture);
    Q_EMIT changed();
}

void LessonModel::apply(const Setting& wanted)
{
    m_target = wanted.to;
    m_showsView = wanted.showsView;
    pause();
    if (wanted.on) {
        shareOnce();
        come();
        show(m_station, wanted, m_picture);
        for (auto& [station, left] : m_left)
            left.setting.on = false; // what is switched on last goes on
    } else {
        withdraw();
        if (isOn())
            m_session.node().propose(m_station, fact::LessonEnded{});
    }
    Q_EMIT changed();
}

/// What this person shows, they show where they are: so do their view and pointer go.
void LessonModel::come()
{
    SessionNode& node = m_session.node();
    if (ownStation(node) != m_station)
        node.propose(m_station, fact::ParticipantMoved{node.self()});
}

/// Unless it is shown already.
void LessonModel::show(StationId station, const Setting& wanted, Lesson picture)
{
    SessionNode& node = m_session.node();
    const auto state = node.state();
    picture.showsView = wanted.showsView;
    const ShownLesson* now = shown(*state, station);
    if (!now || now->to != wanted.to || now->lesson != picture)
        node.propose(station, fact::LessonShown{wanted.to, std::move(picture)});
}

void LessonModel::shareOnce()
{
    if (std::exchange(m_isShared, true))
        return;
    SessionNode& node = m_session.node();
    node.publish(ObjectKind::View, "View", resting(m_view, node));
    node.publish(ObjectKind::Pointer, "Pointer", resting(m_pointer, node));
}

/// Others neither look from here nor see a pointer any more.
void LessonModel::withdraw()
{
    m_view->set(std::nullopt);
    m_pointer->set(std::nullopt);
}

void LessonModel::follow(const Lesson& picture)
{
    m_picture = picture;
    const auto now = m_session.node().now();
    if (!now || *now < m_nextPicture || !isOn() || isUnderWay(m_session.node()))
        return;
    m_target = target();
    pause();
    show(m_station, {true, m_target, m_showsView}, m_picture);
}

/// Also after the end, so that no picture follows it that was on its way.
void LessonModel::pause()
{
    if (const auto now = m_session.node().now())
        m_nextPicture = *now + kShortestPause;
}

std::optional<PoseSample> LessonModel::poseNow(const RigidTransform& X_AO) const
{
    const auto now = m_session.node().now();
    return now && isOn() ? std::optional{PoseSample{.time = *now, .X_FO = X_AO}} : std::nullopt;
}

void LessonModel::lookFrom(const RigidTransform& X_AD)
{
    m_view->set(m_showsView ? poseNow(X_AD) : std::nullopt);
}

void LessonModel::pointWith(const std::optional<RigidTransform>& X_AP)
{
    m_pointer->set(X_AP ? poseNow(*X_AP) : std::nullopt);
}

ObjectPoses LessonModel::poses() const
{
    ObjectPoses own;
    own.at = [pose = m_pointer](ObjectKind kind, SessionTime) {
        return kind == ObjectKind::Pointer ? pose->newest() : std::nullopt;
    };
    return own;
}

QString LessonModel::nameOf(ParticipantId target) const
{
    const auto state = m_session.node().state();
    const auto who = state->participants().find(target);
    return who == state->participants().end() ? tr("everybody")
                                              : QString::fromStdString(who->second.name);
}

QString LessonModel::changeText(const Setting& wanted) const
{
    if (!wanted.on)
        return tr("Showing → off");
    return wanted.showsView ? tr("Showing, with the view → %1").arg(nameOf(wanted.to))
                            : tr("Showing → %1").arg(nameOf(wanted.to));
}

QString LessonModel::text() const
{
    const auto state = m_session.node().state();
    const auto station = state->stations().find(m_station);
    if (station == state->stations().end() || !station->second.lesson)
        return {};
    const ShownLesson& lesson = *station->second.lesson;
    const QString what = lessonText(lesson.lesson, m_pointer->newest().has_value());
    return lesson.by == m_session.node().self()
               ? tr("● Shown to %1: %2; your mouse over the picture is the pointer",
                    "whom; what is shown")
                     .arg(nameOf(lesson.to), what)
               : tr("◆ %1 shows to %2: %3").arg(nameOf(lesson.by), nameOf(lesson.to), what);
}

QString LessonModel::elsewhereText() const
{
    const auto state = m_session.node().state();
    for (const auto& [id, station] : state->stations())
        if (id != m_station && !station.closed && shown(*state, id))
            return tr("● Still shown at %1 to %2: %3", "a station; whom; what is shown")
                .arg(QString::fromStdString(station.name), nameOf(station.lesson->to),
                     lessonText(station.lesson->lesson, false));
    return {};
}

} // namespace carina
