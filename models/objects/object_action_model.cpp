#include "models/objects/object_action_model.h"

#include "engine/sync/wire/sequence.h"
#include "models/objects/object_words.h"
#include "models/patient/shared_patient.h"

#include <QTimer>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr int kMotionInterval_ms = 100;
constexpr double kAlongAxis = 0.9999; ///< cosine from which on an axis is called x, y or z

/// An action's speed as a person reads it, and back. Scaling is told as growth within a second.
double rateFor(ActionKind kind, double speed)
{
    switch (kind) {
    case ActionKind::Rotation:
        return degrees(speed).si;
    case ActionKind::Translation:
        return millimetres(speed).si;
    case ActionKind::Scaling:
        return std::log1p(0.01 * speed);
    }
    return 0.0;
}

double speedOf(ActionKind kind, double rate)
{
    switch (kind) {
    case ActionKind::Rotation:
        return inDegrees(radians(rate));
    case ActionKind::Translation:
        return inMillimetres(metres(rate));
    case ActionKind::Scaling:
        return 100.0 * std::expm1(rate);
    }
    return 0.0;
}

QString number(double value) { return QString::number(value, 'f', 1); }

/// The letter of an axis, and in which direction along it; the numbers of any other.
std::pair<QString, double> axisText(const Vec3& axis_A)
{
    Eigen::Index longest = 0;
    axis_A.cwiseAbs().maxCoeff(&longest);
    if (std::abs(axis_A[longest]) < kAlongAxis)
        return {QStringLiteral("(%1, %2, %3)")
                    .arg(axis_A.x(), 0, 'f', 2)
                    .arg(axis_A.y(), 0, 'f', 2)
                    .arg(axis_A.z(), 0, 'f', 2),
                1.0};
    return {QStringLiteral("xyz").mid(int(longest), 1), std::copysign(1.0, axis_A[longest])};
}

bool isSameMotion(const ShownObject& shown, const ObjectAction& action)
{
    const bool isAlong =
        action.kind == ActionKind::Scaling || shown.axis_A.dot(action.axis_A) > kAlongAxis;
    return shown.kind == action.kind && isAlong
           && float(shown.rate) == float(action.rate); // as it travels
}

} // namespace

ObjectActionModel::ObjectActionModel(SharedObjectModel& object, QObject* parent)
    : QObject{parent}, m_object{object}
{
    connect(&m_object, &SharedObjectModel::changed, this, [this] {
        forgetLost();
        returnTaken();
        Q_EMIT changed();
    });
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &ObjectActionModel::look);
    timer->start(kMotionInterval_ms);
}

void ObjectActionModel::setHistory(ChangeHistory& history)
{
    m_history = &history;
    m_object.setHistory(history);
}

void ObjectActionModel::setKind(ActionKind kind)
{
    m_kind = kind;
    Q_EMIT changed();
}

void ObjectActionModel::setAxis(Axis axis)
{
    m_axis = axis;
    Q_EMIT changed();
}

void ObjectActionModel::setSpeed(double speed)
{
    const double largest = speedScale(m_kind).largest;
    m_speeds[std::size_t(m_kind)] = std::clamp(speed, -largest, largest);
    Q_EMIT changed();
}

ObjectActionModel::SpeedScale ObjectActionModel::speedScale(ActionKind kind)
{
    switch (kind) {
    case ActionKind::Rotation:
        return {360.0, tr("°/s")};
    case ActionKind::Translation:
        return {200.0, tr("mm/s")};
    case ActionKind::Scaling:
        return {50.0, tr("%/s")};
    }
    return {};
}

ObjectAction ObjectActionModel::chosenAction() const
{
    return {m_kind, Vec3::Unit(Eigen::Index(m_axis)), rateFor(m_kind, speed())};
}

std::optional<ShownObject> ObjectActionModel::shown() const
{
    const auto object = m_object.chosen();
    return object ? shownOf(object->id) : std::nullopt;
}

std::optional<ShownObject> ObjectActionModel::shownOf(ObjectId object) const
{
    const SessionNode& node = m_object.session().node();
    const auto now = node.now();
    return now ? node.shown(object, *now) : std::nullopt;
}

bool ObjectActionModel::canStart() const
{
    if (!m_object.isOwn() || !m_object.session().node().now() || speed() == 0.0)
        return false;
    const auto shown = this->shown();
    return !shown || !isSameMotion(*shown, chosenAction());
}

bool ObjectActionModel::canStop() const
{
    const auto shown = this->shown();
    return m_object.isOwn() && shown && shown->rate != 0.0;
}

bool ObjectActionModel::canReset() const { return canStop() || (m_object.isOwn() && !isInPlace()); }

void ObjectActionModel::start()
{
    if (!canStart())
        return;
    remember(m_object.chosen()->id, stepText());
    act(chosenAction());
}

void ObjectActionModel::stop()
{
    if (canStop())
        act({});
}

void ObjectActionModel::reset()
{
    if (!canReset())
        return;
    remember(m_object.chosen()->id, tr("%1 → original place"));
    act({.anew = true});
}

QString ObjectActionModel::stepText() const
{
    const QString axis = QStringLiteral("xyz").mid(int(m_axis), 1);
    switch (m_kind) {
    case ActionKind::Rotation:
        return tr("%1: turned about %2").arg(QStringLiteral("%1"), axis);
    case ActionKind::Translation:
        return tr("%1: moved along %2").arg(QStringLiteral("%1"), axis);
    case ActionKind::Scaling:
        return tr("%1: size changed");
    }
    return {};
}

void ObjectActionModel::remember(ObjectId object, const QString& what)
{
    const auto state = m_object.session().node().state();
    const SharedObject& moved = state->objects().at(object);
    if (m_history)
        m_history->add(
            *this, what.arg(objectWord(moved)), [this, object] { undoOf(object); }, object.value,
            moved.station);
    const auto shown = shownOf(object);
    std::vector<ActedPose>& steps = m_steps[object];
    steps.push_back(shown ? shown->acted : ActedPose{});
    if (steps.size() > kMostSteps)
        steps.erase(steps.begin());
}

/// What others did since cannot be undone by a pose from before, and at a station that was closed
/// nothing is undone.
void ObjectActionModel::forgetLost()
{
    const auto state = m_object.session().node().state();
    const ParticipantId self = m_object.session().node().self();
    std::erase_if(m_steps, [&](const auto& entry) {
        const auto object = state->objects().find(entry.first);
        const bool isLost = object == state->objects().end()
                            || !state->isOpen(object->second.station)
                            || (object->second.owner != self && object->second.owner != kNobody);
        if (isLost && m_history)
            m_history->forget(*this, entry.first.value);
        return isLost;
    });
}

bool ObjectActionModel::canUndo() const
{
    const auto object = m_object.chosen();
    return object && m_object.isOwn() && m_object.session().node().now()
           && m_steps.contains(object->id);
}

void ObjectActionModel::undo()
{
    if (!canUndo())
        return;
    undoOf(m_object.chosen()->id);
}

void ObjectActionModel::undoOf(ObjectId object)
{
    const auto steps = m_steps.find(object);
    if (steps == m_steps.end())
        return;
    const ActedPose before = steps->second.back();
    steps->second.pop_back();
    if (steps->second.empty())
        m_steps.erase(steps);
    bringTo(object, before);
}

/// What was put back is lifted out again for it.
void ObjectActionModel::bringTo(ObjectId object, const ActedPose& pose)
{
    SessionNode& node = m_object.session().node();
    const auto state = node.state();
    const auto found = state->objects().find(object);
    if (found == state->objects().end())
        return;
    const SharedObject& at = found->second;
    if (at.owner == node.self()) {
        std::erase_if(m_returns, [object](const Return& each) { return each.object == object; });
        node.act(object, {.from = pose, .anew = true});
        return look();
    }
    const Return back{object, std::uint16_t(at.epoch + 1), pose, {}};
    const auto underWay = std::ranges::find(m_returns, object, &Return::object);
    if (underWay != m_returns.end() && underWay->epoch == back.epoch) {
        *underWay = back; // of several steps at once
        return;
    }
    m_returns.push_back(back);
    node.propose(at.station, fact::ObjectHandedOver{object, node.self(), at.epoch});
}

void ObjectActionModel::putBack()
{
    if (!m_object.canPutBack())
        return;
    const ObjectId object = m_object.chosen()->id;
    if (m_object.isOwn())
        remember(object, tr("%1 → put back"));
    m_object.putBack(object);
    look();
}

const SharedObject* ObjectActionModel::strayPatient(const SessionState& state) const
{
    const SharedObject* patient = sharedPatient(state, m_object.station());
    const auto shown = patient ? shownOf(patient->id) : std::nullopt;
    const bool isStray = shown && (shown->rate != 0.0 || !isInItsPlace(shown->acted));
    const bool isOwn = patient && patient->owner == m_object.session().node().self();
    const bool may = isStray && m_object.obstacle().isEmpty() && (isOwn || m_object.isInstructor());
    return may ? patient : nullptr;
}

bool ObjectActionModel::canPutAllBack() const
{
    const auto state = m_object.session().node().state();
    return !m_object.toPutBack().empty() || strayPatient(*state);
}

void ObjectActionModel::putAllBack()
{
    SessionNode& node = m_object.session().node();
    const auto state = node.state();
    const auto joint =
        m_history ? m_history->newJoint(tr("Everything put back")) : ChangeHistory::Joint{};
    const ChangeHistory::Joining joining{m_history, joint};
    for (const ObjectId object : m_object.toPutBack()) {
        if (state->objects().at(object).owner == node.self())
            remember(object, tr("%1 → put back"));
        m_object.putBack(object);
    }
    if (const SharedObject* patient = strayPatient(*state)) {
        const bool isOwn = patient->owner == node.self();
        m_returns.push_back(
            {patient->id, std::uint16_t(patient->epoch + (isOwn ? 0 : 1)), {}, joint});
        if (!isOwn)
            m_object.take(*patient);
        returnTaken();
    }
    look();
}

/// Once it is this person's; unless another took it meanwhile.
void ObjectActionModel::returnTaken()
{
    SessionNode& node = m_object.session().node();
    const auto state = node.state();
    std::vector<Return> due;
    std::erase_if(m_returns, [&](const Return& each) {
        const auto object = state->objects().find(each.object);
        if (object == state->objects().end() || isAfter(each.epoch, object->second.epoch))
            return false;
        if (each.epoch == object->second.epoch && object->second.owner == node.self())
            due.push_back(each);
        return true;
    });
    for (const Return& each : due) {
        const ChangeHistory::Joining joining{m_history, each.joint};
        if (!each.to)
            remember(each.object, tr("%1 → original place"));
        node.act(each.object, {.from = each.to.value_or(ActedPose{}), .anew = true});
    }
}

void ObjectActionModel::act(const ObjectAction& action)
{
    if (const auto object = m_object.chosen())
        m_object.session().node().act(object->id, action);
    look();
}

QString ObjectActionModel::motionText() const
{
    const auto shown = this->shown();
    if (!m_object.chosen())
        return {};
    if (!shown || shown->rate == 0.0)
        return tr("■ At rest");
    const auto [axis, direction] = axisText(shown->axis_A);
    const double speed = speedOf(shown->kind, shown->rate);
    const QString unit = speedScale(shown->kind).unit;
    QString text;
    switch (shown->kind) {
    case ActionKind::Rotation:
        text = tr("● Turns about %1 at %2 %3").arg(axis, number(direction * speed), unit);
        break;
    case ActionKind::Translation:
        text = tr("● Moves along %1 at %2 %3").arg(axis, number(direction * speed), unit);
        break;
    case ActionKind::Scaling:
        text = tr("● Changes its size by %1 %2").arg(number(speed), unit);
        break;
    }
    return shown->isStale ? tr("%1 (no data from its owner)").arg(text) : text;
}

bool ObjectActionModel::isInPlace() const
{
    const auto shown = this->shown();
    return !shown || isInItsPlace(shown->acted);
}

QString ObjectActionModel::placeText() const
{
    if (!m_object.chosen())
        return {};
    const auto shown = this->shown();
    if (!shown || isInItsPlace(shown->acted))
        return tr("In its original place");
    const Displacement displacement = displacementOf(shown->acted);
    return tr("▲ Away from its original place: turned %1°, moved %2\u00a0mm, size %3\u00a0%")
        .arg(number(displacement.turned_deg), number(displacement.moved_mm),
             number(displacement.size_percent));
}

void ObjectActionModel::look()
{
    Shown shown{motionText(), placeText()};
    if (shown == m_told)
        return;
    m_told = std::move(shown);
    Q_EMIT changed();
}

} // namespace carina
