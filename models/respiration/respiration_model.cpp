#include "models/respiration/respiration_model.h"

#include "models/respiration/respiration_words.h"

#include <QTimer>

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

/// How often a change under way is looked for; nothing signals the moment a fact takes effect.
constexpr int kRespirationLook_ms = 50;
constexpr std::array kThingNames{QT_TRANSLATE_NOOP("carina::RespirationModel", "Condition → %1"),
                                 QT_TRANSLATE_NOOP("carina::RespirationModel", "Ventilation → %1"),
                                 QT_TRANSLATE_NOOP("carina::RespirationModel", "Airway → %1"),
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
    QString operator()(Length innerDiameter) const { return tubeText(innerDiameter); }
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
    FactBody operator()(Length innerDiameter) const { return fact::TubePlaced{innerDiameter}; }
    FactBody operator()(BodyPosition position) const { return fact::BodyPositionSet{position}; }
};

} // namespace

RespirationModel::RespirationModel(SessionModel& session, StationId station, QObject* parent)
    : QObject{parent}, m_session{session}, m_stations{station}
{
    connect(&m_session, &SessionModel::changed, this, &RespirationModel::refresh);
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &RespirationModel::refresh);
    timer->start(kRespirationLook_ms);
}

void RespirationModel::setStation(StationId station)
{
    if (std::exchange(m_stations.shown, station) == station)
        return;
    for (const Wish& wish : m_wishes) // what waits goes now
        if (wish.latest)
            propose(*wish.latest);
    m_wishes = {};
    refresh();
    Q_EMIT changed();
}

LungConditions RespirationModel::conditions() const { return std::get<LungConditions>(shown(0)); }
VentilatorSettings RespirationModel::ventilator() const
{
    return std::get<VentilatorSettings>(shown(1));
}
Length RespirationModel::tube() const { return std::get<Length>(shown(2)); }
BodyPosition RespirationModel::position() const { return std::get<BodyPosition>(shown(3)); }

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
    const auto conditions = std::get<LungConditions>(inForce(0));
    QString ailment = conditionText(conditions);
    if (ownBreathing() == 0.0)
        ailment = conditions.empty()
                      ? tr("Own breathing has stopped")
                      : tr("%1; own breathing has stopped", "what ails the patient").arg(ailment);
    const auto position = std::get<BodyPosition>(inForce(3));
    if (position == BodyPosition::Supine)
        return ailment;
    return tr("%1; %2", "what ails the patient; how it lies")
        .arg(ailment, positionText(position).toLower());
}

QString RespirationModel::travellingText() const
{
    QStringList lines;
    for (std::size_t thing = 0; thing < kThings; ++thing)
        if (const auto decision = pending(thing))
            lines << tr(kThingNames[thing]).arg(std::visit(DecisionText{}, *decision));
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
                                                  settings.tube, settings.position};
    return decisions[thing];
}

RespirationModel::Decision RespirationModel::inForce(std::size_t thing) const
{
    return decidedAt(m_stations.shown, thing, m_session.node().now().value_or(SessionTime{}));
}

/// The share that is left of it now.
double RespirationModel::ownBreathing() const
{
    const auto state = m_session.node().state();
    const auto station = state->stations().find(m_stations.shown);
    const SessionTime now = m_session.node().now().value_or(SessionTime{});
    return station == state->stations().end()
               ? 1.0
               : station->second.respiration.settingsAt(now).ownBreathing;
}

std::optional<RespirationModel::Decision> RespirationModel::pending(std::size_t thing) const
{
    const Wish& wish = m_wishes[thing];
    const std::optional<Setting>& wanted = wish.latest ? wish.latest : wish.sent;
    return wanted ? std::optional{wanted->decision} : std::nullopt;
}

RespirationModel::Decision RespirationModel::shown(std::size_t thing) const
{
    return pending(thing).value_or(inForce(thing));
}

/// The values that a change would replace, at the shown station also one that is under way.
std::vector<RespirationModel::Setting> RespirationModel::present(std::size_t thing) const
{
    std::vector<Setting> settings;
    for (const StationId id : stationsOf(*m_session.node().state(), m_stations.target()))
        settings.push_back(
            {id, id == m_stations.shown ? shown(thing) : decidedAt(id, thing, SessionTime::max())});
    return settings;
}

void RespirationModel::set(const Decision& decision)
{
    const std::size_t thing = decision.index();
    const std::vector<Setting> before = present(thing);
    const auto isSo = [&](const Setting& at) { return at.decision == decision; };
    if (std::ranges::all_of(before, isSo) || !obstacle().isEmpty())
        return;
    // A drag is one change: only its first step is what undo goes back to.
    const QString text = tr(kThingNames[thing]).arg(std::visit(DecisionText{}, decision));
    const Setting wanted{m_stations.target(), decision};
    if (pending(thing) && m_steps.lastIsAbout(thing, wanted.station))
        m_steps.goOn(wanted, text);
    else
        m_steps.add(thing, wanted, before, text,
                    [this](const auto& step) { goBackTo(step.before); });
    ask(wanted);
}

void RespirationModel::undo()
{
    if (const auto step = m_steps.takeLast())
        goBackTo(step->before);
}

void RespirationModel::goBackTo(const std::vector<Setting>& before)
{
    for (const Setting& at : before)
        if (at.station == m_stations.shown)
            ask(at);
        else
            propose(at);
}

void RespirationModel::ask(const Setting& setting)
{
    Wish& wish = m_wishes[setting.decision.index()];
    if (wish.sent) {
        wish.latest = setting;
    } else {
        wish.sent = setting;
        propose(setting);
    }
    Q_EMIT changed();
}

void RespirationModel::propose(const Setting& setting)
{
    m_session.node().propose(setting.station, std::visit(DecisionFact{}, setting.decision));
}

bool RespirationModel::isUnderWay(const Decision& sent) const
{
    if (inForce(sent.index()) == sent)
        return false;
    if (!m_session.node().pending().empty())
        return true; // the host has not answered yet
    // Decided for later, unless the host refused it or somebody decided otherwise since.
    return decidedAt(m_stations.shown, sent.index(), SessionTime::max()) == sent;
}

bool RespirationModel::isDecided(StationId station, const Decision& decision) const
{
    return m_session.node().state()->isOpen(station)
           && decidedAt(station, decision.index(), SessionTime::max()) == decision;
}

void RespirationModel::refresh()
{
    for (Wish& wish : m_wishes) {
        if (!wish.sent || isUnderWay(wish.sent->decision))
            continue;
        wish.sent.reset();
        if (const auto next = std::exchange(wish.latest, std::nullopt))
            ask(*next);
    }
    if (m_session.node().pending().empty())
        m_steps.dropOverruled([this](const auto& step, StationId station) {
            return m_wishes[step.thing].sent || isDecided(station, step.set.decision);
        });
    Shown now;
    for (std::size_t thing = 0; thing < kThings; ++thing) {
        now.decisions[thing] = shown(thing);
        now.pending[thing] = pending(thing).has_value();
    }
    now.obstacle = obstacle();
    now.canUndo = canUndo();
    if (std::exchange(m_shown, now) != now)
        Q_EMIT changed();
}

} // namespace carina
