#include "models/respiration/breathing_model.h"

#include "engine/session/facts/fact_rules.h"

#include <QTimer>

#include <algorithm>
#include <cmath>

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

BreathingPattern patternAt(const SessionNode& node, StationId stationId, SessionTime t)
{
    return settingsAt(node, stationId, t).pattern;
}

double expirationOf(double inspiratoryFraction)
{
    return (1.0 - inspiratoryFraction) / inspiratoryFraction;
}

double fractionOf(double expiration) { return 1.0 / (1.0 + expiration); }

double valueOf(const BreathingPattern& pattern, BreathingParameter parameter)
{
    switch (parameter) {
    case BreathingParameter::Rate:
        return inPerMinute(pattern.rate);
    case BreathingParameter::TidalVolume:
        return inMillilitres(pattern.tidalVolume);
    case BreathingParameter::Expiration:
        return expirationOf(pattern.inspiratoryFraction);
    }
    return 0.0;
}

bool same(double a, double b) { return std::abs(a - b) <= kSame * std::max(1.0, std::abs(b)); }

} // namespace

BreathingModel::BreathingModel(SessionModel& session, StationId station, QObject* parent)
    : QObject{parent}, m_session{session}, m_stations{station}
{
    connect(&m_session, &SessionModel::changed, this, &BreathingModel::refresh);
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &BreathingModel::refresh);
    timer->start(kLookInterval_ms);
}

void BreathingModel::setStation(StationId station)
{
    if (std::exchange(m_stations.shown, station) == station)
        return;
    m_wishes = {};
    m_undo.clear();
    refresh();
    Q_EMIT changed();
}

void BreathingModel::setForAll(bool all)
{
    m_stations.all = all;
    refresh();
}

double BreathingModel::value(BreathingParameter parameter) const
{
    const SessionTime now = m_session.node().now().value_or(SessionTime{});
    return valueOf(patternAt(m_session.node(), m_stations.shown, now), parameter);
}

std::optional<double> BreathingModel::pending(BreathingParameter parameter) const
{
    const Wish& wish = m_wishes[std::size_t(parameter)];
    const std::optional<Setting>& wanted = wish.latest ? wish.latest : wish.sent;
    return wanted ? std::optional{wanted->value} : std::nullopt;
}

/// By what was last decided about each patient, as the host judges it.
int BreathingModel::largestTidalVolume_ml() const
{
    const SessionNode& node = m_session.node();
    Volume largest = kLargestTidalVolume;
    for (const StationId station : stationsOf(*node.state(), m_stations.target()))
        largest = std::min(largest,
                           largestTidalVolume(settingsAt(node, station, SessionTime::max()).build));
    return static_cast<int>(inMillilitres(largest) + kSame);
}

QString BreathingModel::travellingText() const
{
    QStringList lines;
    if (const auto rate = pending(BreathingParameter::Rate))
        lines << tr("Breathing rate → %1\u00a0/min").arg(*rate);
    if (const auto volume = pending(BreathingParameter::TidalVolume))
        lines << tr("Tidal volume → %1\u00a0ml").arg(*volume);
    if (const auto expiration = pending(BreathingParameter::Expiration))
        lines << tr("Inspiration : expiration → 1 : %1").arg(*expiration, 0, 'f', 2);
    return lines.join(QLatin1Char('\n'));
}

/// The values that a change would replace, at the shown station also one that is under way.
std::vector<BreathingModel::Setting> BreathingModel::present(BreathingParameter parameter) const
{
    const SessionNode& node = m_session.node();
    std::vector<Setting> settings;
    for (const StationId station : stationsOf(*node.state(), m_stations.target()))
        settings.push_back(
            {station, valueOf(patternAt(node, station, SessionTime::max()), parameter)});
    const auto underWay = pending(parameter);
    for (Setting& setting : settings)
        if (setting.station == m_stations.shown)
            setting.value = underWay.value_or(value(parameter));
    return settings;
}

void BreathingModel::set(BreathingParameter parameter, double value)
{
    const std::vector<Setting> before = present(parameter);
    if (std::ranges::all_of(before, [&](const Setting& at) { return same(value, at.value); }))
        return;
    // A drag is one change: only its first step is what undo goes back to.
    if (!pending(parameter) || m_undo.empty() || m_undo.back().parameter != parameter)
        m_undo.push_back({parameter, before});
    ask(parameter, {m_stations.target(), value});
}

void BreathingModel::undo()
{
    if (m_undo.empty())
        return;
    const Change change = m_undo.back();
    m_undo.pop_back();
    for (const Setting& before : change.before)
        if (before.station == m_stations.shown)
            ask(change.parameter, before);
        else
            propose(change.parameter, before);
}

void BreathingModel::ask(BreathingParameter parameter, const Setting& setting)
{
    Wish& wish = m_wishes[std::size_t(parameter)];
    if (wish.sent) {
        wish.latest = setting;
    } else {
        wish.sent = setting;
        propose(parameter, setting);
    }
    Q_EMIT changed();
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
    }
}

bool BreathingModel::isUnderWay(BreathingParameter parameter, double sent) const
{
    const SessionNode& node = m_session.node();
    if (same(value(parameter), sent))
        return false; // in force
    if (!node.pending().empty())
        return true; // the host has not answered yet
    // Decided for later, unless the host refused it or somebody decided otherwise since.
    return same(valueOf(patternAt(node, m_stations.shown, SessionTime::max()), parameter), sent);
}

void BreathingModel::refresh()
{
    for (const BreathingParameter parameter : kBreathingParameters) {
        Wish& wish = m_wishes[std::size_t(parameter)];
        if (wish.sent && !isUnderWay(parameter, wish.sent->value)) {
            wish.sent.reset();
            if (const auto next = std::exchange(wish.latest, std::nullopt))
                ask(parameter, *next);
        }
    }
    Shown shown{{}, largestTidalVolume_ml()};
    for (const BreathingParameter parameter : kBreathingParameters)
        shown.values[std::size_t(parameter)] = {value(parameter), pending(parameter)};
    if (std::exchange(m_shown, shown) != shown)
        Q_EMIT changed();
}

} // namespace carina
