#include "models/respiration/respiration_model.h"

#include "models/respiration/respiration_words.h"

#include <QTimer>

#include <utility>

namespace carina
{
namespace
{

/// How often a change under way is looked for; nothing signals the moment a fact takes effect.
constexpr int kRespirationLook_ms = 50;
constexpr std::array kThingNames{QT_TRANSLATE_NOOP("carina::RespirationModel", "Condition → %1"),
                                 QT_TRANSLATE_NOOP("carina::RespirationModel", "Ventilation → %1"),
                                 QT_TRANSLATE_NOOP("carina::RespirationModel", "Position → %1")};

bool isUsuallyOfOneLung(ConditionKind kind)
{
    return kind == ConditionKind::SimplePneumothorax || kind == ConditionKind::TensionPneumothorax
           || kind == ConditionKind::Atelectasis || kind == ConditionKind::MainstemIntubation;
}

struct DecisionText {
    QString operator()(const LungConditions& conditions) const { return conditionText(conditions); }
    QString operator()(const VentilatorSettings& settings) const
    {
        return ventilatorText(settings);
    }
    QString operator()(BodyPosition position) const { return positionText(position); }
};

struct DecisionFact {
    FactBody operator()(const LungConditions& conditions) const
    {
        return fact::LungConditionsSet{conditions};
    }
    FactBody operator()(const VentilatorSettings& settings) const
    {
        return fact::VentilatorSet{settings};
    }
    FactBody operator()(BodyPosition position) const { return fact::BodyPositionSet{position}; }
};

} // namespace

RespirationModel::RespirationModel(SessionModel& session, StationId station, QObject* parent)
    : QObject{parent}, m_session{session}, m_changes{session, station, *this, quantities()}
{
    connect(&m_session, &SessionModel::changed, this, &RespirationModel::refresh);
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &RespirationModel::refresh);
    timer->start(kRespirationLook_ms);
}

RespirationModel::Changes::Quantities RespirationModel::quantities()
{
    return {.decidedAt = [this](StationId station, std::size_t thing,
                                SessionTime t) { return decidedAt(station, thing, t); },
            .propose =
                [this](std::size_t /*thing*/, const Changes::Setting& setting) {
                    m_session.node().propose(setting.station,
                                             std::visit(DecisionFact{}, setting.value));
                },
            .textOf = [](std::size_t thing,
                         const Decision& decision) { return textOf(thing, decision); },
            .requested = [this] { Q_EMIT changed(); }};
}

void RespirationModel::setStation(StationId station)
{
    if (!m_changes.setStation(station))
        return;
    refresh();
    Q_EMIT changed();
}

LungConditions RespirationModel::conditions() const
{
    return std::get<LungConditions>(m_changes.shown(0));
}
VentilatorSettings RespirationModel::ventilator() const
{
    return std::get<VentilatorSettings>(m_changes.shown(1));
}
BodyPosition RespirationModel::position() const
{
    return std::get<BodyPosition>(m_changes.shown(2));
}

std::optional<LungConditions> RespirationModel::with(std::size_t place, ConditionKind kind) const
{
    constexpr double kUsual = 0.5;
    LungConditions all = conditions();
    if (place > all.size())
        return std::nullopt;
    if (place == all.size())
        all.emplace_back();
    const LungCondition before = all[place];
    const ConditionSide one =
        before.side == ConditionSide::Both ? ConditionSide::Right : before.side;
    const ConditionSide usual = isUsuallyOfOneLung(kind) ? one : ConditionSide::Both;
    for (const ConditionSide side : {usual, one, ConditionSide::Right, ConditionSide::Left}) {
        all[place] = {kind, before.severity > 0.0 ? before.severity : kUsual, side};
        if (canCoexist(all))
            return all;
    }
    return std::nullopt;
}

bool RespirationModel::canChoose(std::size_t place, ConditionKind kind) const
{
    return kind == ConditionKind::Normal || with(place, kind).has_value();
}

void RespirationModel::choose(std::size_t place, ConditionKind kind)
{
    if (kind == ConditionKind::Normal)
        return removeCondition(place);
    if (const auto all = with(place, kind))
        set(*all);
}

void RespirationModel::setCondition(std::size_t place, LungCondition condition)
{
    LungConditions all = conditions();
    if (place > all.size())
        return;
    if (condition.kind == ConditionKind::MainstemIntubation
        && condition.side == ConditionSide::Both)
        condition.side = ConditionSide::Right;
    if (place == all.size())
        all.push_back(condition);
    else
        all[place] = condition;
    if (canCoexist(all))
        set(all);
}

void RespirationModel::removeCondition(std::size_t place)
{
    LungConditions all = conditions();
    if (place >= all.size())
        return;
    all.erase(all.begin() + std::ptrdiff_t(place));
    set(all);
}

QString RespirationModel::inForceText() const
{
    const auto conditions = std::get<LungConditions>(m_changes.inForce(0));
    QString ailment = conditionText(conditions);
    if (ownBreathing() == 0.0)
        ailment = conditions.empty()
                      ? tr("Own breathing has stopped")
                      : tr("%1; own breathing has stopped", "what ails the patient").arg(ailment);
    const auto position = std::get<BodyPosition>(m_changes.inForce(2));
    if (position == BodyPosition::Supine)
        return ailment;
    return tr("%1; %2", "what ails the patient; how it lies")
        .arg(ailment, positionText(position).toLower());
}

QString RespirationModel::travellingText() const
{
    QStringList lines;
    for (std::size_t thing = 0; thing < kThings; ++thing)
        if (const auto& wanted = m_changes.pending(thing))
            lines << textOf(thing, wanted->value);
    return lines.join(QLatin1Char('\n'));
}

RespirationModel::Decision RespirationModel::decidedAt(StationId id, std::size_t thing,
                                                       SessionTime t) const
{
    const auto state = m_session.node().state();
    const auto station = state->stations().find(id);
    const RespiratorySettings settings = station != state->stations().end()
                                             ? station->second.respiration.settingsAt(t)
                                             : RespiratorySettings{};
    const std::array<Decision, kThings> decisions{settings.conditions, settings.ventilator,
                                                  settings.position};
    return decisions[thing];
}

/// The share that is left of it now.
double RespirationModel::ownBreathing() const
{
    const auto state = m_session.node().state();
    const auto station = state->stations().find(m_changes.stations().shown);
    const SessionTime now = m_session.node().now().value_or(SessionTime{});
    return station == state->stations().end()
               ? 1.0
               : station->second.respiration.settingsAt(now).ownBreathing;
}

QString RespirationModel::textOf(std::size_t thing, const Decision& decision)
{
    return tr(kThingNames[thing]).arg(std::visit(DecisionText{}, decision));
}

void RespirationModel::set(const Decision& decision)
{
    if (obstacle().isEmpty())
        m_changes.set(decision.index(), decision);
}

void RespirationModel::refresh()
{
    m_changes.follow();
    Shown now;
    for (std::size_t thing = 0; thing < kThings; ++thing) {
        now.decisions[thing] = m_changes.shown(thing);
        now.pending[thing] = m_changes.pending(thing).has_value();
    }
    now.obstacle = obstacle();
    now.canUndo = canUndo();
    if (std::exchange(m_shown, now) != now)
        Q_EMIT changed();
}

} // namespace carina
