#include "models/respiration/breathing_model.h"

#include "engine/session/facts/fact_rules.h"

#include <QTimer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

/// How often a change under way is looked for; nothing signals the moment a fact takes effect.
constexpr int kLookInterval_ms = 50;
/// The coarsest rounding between what was asked and what a timeline gives back.
constexpr double kSame = 1e-6;

RespiratorySettings settingsAt(const SessionNode& node, StationId stationId, SessionTime t)
{
    const auto state = node.state();
    const auto station = state->stations().find(stationId);
    return station != state->stations().end() ? station->second.respiration.settingsAt(t)
                                              : RespiratorySettings{};
}

double expirationOf(double inspiratoryFraction)
{
    return (1.0 - inspiratoryFraction) / inspiratoryFraction;
}

double fractionOf(double expiration) { return 1.0 / (1.0 + expiration); }

double valueOf(const RespiratorySettings& settings, const OwnBreathing& own,
               BreathingParameter parameter)
{
    switch (parameter) {
    case BreathingParameter::Rate:
        return inPerMinute(settings.pattern.rate);
    case BreathingParameter::TidalVolume:
        return inMillilitres(settings.pattern.tidalVolume);
    case BreathingParameter::Expiration:
        return expirationOf(settings.pattern.inspiratoryFraction);
    case BreathingParameter::Own:
        return own.stopped ? 0.0 : 1.0;
    case BreathingParameter::BagRate:
        return inPerMinute(settings.bag.rate);
    case BreathingParameter::BagVolume:
        return inMillilitres(settings.bag.tidalVolume);
    }
    return 0.0;
}

bool same(double a, double b) { return std::abs(a - b) <= kSame * std::max(1.0, std::abs(b)); }

} // namespace

BreathingModel::BreathingModel(SessionModel& session, StationId station, QObject* parent)
    : QObject{parent}, m_session{session}, m_changes{session, station, *this, quantities()}
{
    connect(&m_session, &SessionModel::changed, this, &BreathingModel::refresh);
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &BreathingModel::refresh);
    timer->start(kLookInterval_ms);
}

BreathingModel::Changes::Quantities BreathingModel::quantities()
{
    const auto parameterOf = [](std::size_t thing) { return kBreathingParameters[thing]; };
    return {.decidedAt =
                [this, parameterOf](StationId station, std::size_t thing, SessionTime t) {
                    return valueAt(station, t, parameterOf(thing));
                },
            .propose =
                [this, parameterOf](std::size_t thing, const Setting& setting) {
                    propose(parameterOf(thing), setting);
                },
            .textOf = [parameterOf](std::size_t thing,
                                    double value) { return textOf(parameterOf(thing), value); },
            .requested = [this] { Q_EMIT changed(); },
            .isSame = same};
}

void BreathingModel::setStation(StationId station)
{
    if (!m_changes.setStation(station))
        return;
    refresh();
    Q_EMIT changed();
}

void BreathingModel::setForAll(bool all)
{
    m_changes.setForAll(all);
    refresh();
}

double BreathingModel::value(BreathingParameter parameter) const
{
    return m_changes.inForce(std::size_t(parameter));
}

double BreathingModel::valueAt(StationId id, SessionTime t, BreathingParameter parameter) const
{
    const auto state = m_session.node().state();
    const auto station = state->stations().find(id);
    const OwnBreathing own = station != state->stations().end()
                                 ? station->second.respiration.ownBreathingAt(t)
                                 : OwnBreathing{};
    return valueOf(settingsAt(m_session.node(), id, t), own, parameter);
}

double BreathingModel::ownBreathing() const
{
    const SessionTime now = m_session.node().now().value_or(SessionTime{});
    return settingsAt(m_session.node(), m_changes.stations().shown, now).ownBreathing;
}

std::optional<double> BreathingModel::pending(BreathingParameter parameter) const
{
    const std::optional<Setting>& wanted = m_changes.pending(std::size_t(parameter));
    return wanted ? std::optional{wanted->value} : std::nullopt;
}

/// By what was last decided about each patient, as the host judges it.
int BreathingModel::largestTidalVolume_ml() const
{
    const SessionNode& node = m_session.node();
    Volume largest = kLargestTidalVolume;
    for (const StationId station : stationsOf(*node.state(), m_changes.stations().target()))
        largest = std::min(largest,
                           largestTidalVolume(settingsAt(node, station, SessionTime::max()).build));
    return static_cast<int>(inMillilitres(largest) + kSame);
}

QString BreathingModel::travellingText() const
{
    QStringList lines;
    for (const BreathingParameter parameter : kBreathingParameters)
        if (const auto value = pending(parameter))
            lines << textOf(parameter, *value);
    return lines.join(QLatin1Char('\n'));
}

QString BreathingModel::textOf(BreathingParameter parameter, double value)
{
    switch (parameter) {
    case BreathingParameter::Rate:
        return tr("Breathing rate → %1\u00a0/min").arg(value);
    case BreathingParameter::TidalVolume:
        return tr("Tidal volume → %1\u00a0ml").arg(value);
    case BreathingParameter::Expiration:
        return tr("Inspiration : expiration → 1 : %1").arg(value, 0, 'f', 2);
    case BreathingParameter::Own:
        return value > 0.0 ? tr("Breathing → goes on") : tr("Breathing → stops");
    case BreathingParameter::BagRate:
        return value > 0.0 ? tr("Bag by hand → %1\u00a0/min").arg(value) : tr("Bag by hand → none");
    case BreathingParameter::BagVolume:
        return tr("Volume of the bag → %1\u00a0ml").arg(value);
    }
    return {};
}

void BreathingModel::propose(BreathingParameter parameter, const Setting& setting)
{
    SessionNode& node = m_session.node();
    switch (parameter) {
    case BreathingParameter::Rate:
        node.propose(setting.station, fact::BreathingRateSet{perMinute(setting.value)});
        break;
    case BreathingParameter::TidalVolume:
        node.propose(setting.station, fact::TidalVolumeSet{millilitres(setting.value)});
        break;
    case BreathingParameter::Expiration:
        node.propose(setting.station, fact::InspiratoryFractionSet{fractionOf(setting.value)});
        break;
    case BreathingParameter::Own:
        node.propose(setting.station, fact::BreathingStopped{setting.value == 0.0, setting.over});
        break;
    case BreathingParameter::BagRate:
    case BreathingParameter::BagVolume:
        proposeBag(parameter, setting);
        break;
    }
}

/// Each station keeps its own other value.
void BreathingModel::proposeBag(BreathingParameter parameter, const Setting& setting)
{
    SessionNode& node = m_session.node();
    for (const StationId station : stationsOf(*node.state(), setting.station)) {
        const auto valueOfBag = [&](BreathingParameter of) {
            return of == parameter ? setting.value : askedAt(station, of);
        };
        node.propose(station,
                     fact::BagSqueezed{{perMinute(valueOfBag(BreathingParameter::BagRate)),
                                        millilitres(valueOfBag(BreathingParameter::BagVolume))}});
    }
}

/// What is decided there or was asked for.
double BreathingModel::askedAt(StationId station, BreathingParameter parameter) const
{
    const std::optional<Setting>& wanted = m_changes.pending(std::size_t(parameter));
    const bool isMeant = wanted && (wanted->station == station || wanted->station == kAllStations);
    return isMeant ? wanted->value : valueAt(station, SessionTime::max(), parameter);
}

void BreathingModel::refresh()
{
    m_changes.follow();
    Shown shown{{}, largestTidalVolume_ml(), ownBreathing(), canUndo()};
    for (const BreathingParameter parameter : kBreathingParameters)
        shown.values[std::size_t(parameter)] = {value(parameter), pending(parameter)};
    if (std::exchange(m_shown, shown) != shown)
        Q_EMIT changed();
}

} // namespace carina
