#include "models/physiology/gas_model.h"

#include "engine/anatomy/patient/patient_dimensions.h"
#include "engine/core/expects.h"
#include "models/physiology/drug_words.h"

#include <QTimer>

#include <algorithm>
#include <memory>

namespace carina
{
namespace
{

/// How often a change under way is looked for; nothing signals the moment a fact takes effect.
constexpr int kGasLook_ms = 50;

/// What was decided about the patient of a station.
class Decided
{
public:
    Decided(const SessionModel& session, StationId id) : m_state{session.node().state()}
    {
        const auto station = m_state->stations().find(id);
        if (station != m_state->stations().end())
            m_timeline = &station->second.respiration;
    }
    const RespirationTimeline* operator->() const { return m_timeline; }

private:
    static inline const RespirationTimeline kNothing{};

    std::shared_ptr<const SessionState> m_state;
    const RespirationTimeline* m_timeline = &kNothing;
};

struct GasFact {
    FactBody operator()(const GasSupply& gas) const { return fact::GasSupplySet{gas}; }
    FactBody operator()(bool inflated) const { return fact::CuffSet{inflated}; }
    FactBody operator()(double share) const { return fact::TubeObstructed{share}; }
    FactBody operator()(const SetTube& tube) const { return fact::TubePlaced{tube}; }
};

} // namespace

GasModel::GasModel(SessionModel& session, StationId station, QObject* parent)
    : QObject{parent}, m_session{session}, m_changes{session, station, *this, quantities()}
{
    connect(&m_session, &SessionModel::changed, this, &GasModel::refresh);
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &GasModel::refresh);
    timer->start(kGasLook_ms);
}

GasModel::Changes::Quantities GasModel::quantities()
{
    return {
        .decidedAt =
            [this](StationId station, std::size_t thing, SessionTime t) {
                const Decided timeline{m_session, station};
                const TubeTimeline& tube = timeline->tube();
                const std::array<Decision, kThings> decisions{
                    timeline->gasAt(t), tube.cuffInflatedAt(t), tube.obstructionAt(t),
                    tube.overrideAt(t)};
                return decisions[thing];
            },
        .propose =
            [this](std::size_t /*thing*/, const Changes::Setting& setting) {
                m_session.node().propose(setting.station, std::visit(GasFact{}, setting.value));
            },
        .textOf = [](std::size_t /*thing*/, const Decision& decision) { return textOf(decision); },
        .requested = [this] { Q_EMIT changed(); }};
}

void GasModel::setStation(StationId station)
{
    if (!m_changes.setStation(station))
        return;
    refresh();
    Q_EMIT changed();
}

void GasModel::setForAll(bool all)
{
    m_changes.setForAll(all);
    Q_EMIT changed(); // of the largest doses
}

GasSupply GasModel::gas() const { return std::get<GasSupply>(m_changes.shown(0)); }
bool GasModel::isCuffInflated() const { return std::get<bool>(m_changes.shown(1)); }
double GasModel::obstruction() const { return std::get<double>(m_changes.shown(2)); }
SetTube GasModel::tube() const { return std::get<SetTube>(m_changes.shown(3)); }

Length GasModel::likelyTubeSize() const
{
    const Decided timeline{m_session, m_changes.stations().shown};
    if (const Length known = timeline->tubePlaceAt(SessionTime::max()).innerDiameter;
        known.si > 0.0)
        return known;
    const PatientBuild build = timeline->settingsAt(SessionTime::max()).build;
    return usualTube(build.ageInYears, build.sex);
}

bool GasModel::hasTube() const
{
    const Decided timeline{m_session, m_changes.stations().shown};
    return timeline->tubePlaceAt(SessionTime::max()).innerDiameter.si > 0.0;
}

bool GasModel::hasStylet() const
{
    const Decided timeline{m_session, m_changes.stations().shown};
    return timeline->tube().isWatchedAt(SessionTime::max())
           && timeline->tube().styletInAt(SessionTime::max());
}

void GasModel::drawStylet()
{
    if (obstacleToTube().isEmpty())
        m_session.node().propose(m_changes.stations().shown, fact::StyletDrawn{});
}

/// By what was last decided about the patient.
double GasModel::weightAt(StationId station) const
{
    return Decided { m_session, station } -> settingsAt(SessionTime::max()).build.weightInKilograms;
}

double GasModel::weight_kg() const { return weightAt(m_changes.stations().shown); }

double GasModel::mostDose_mgPerKg(DrugKind kind) const
{
    double heaviest = weight_kg();
    for (const StationId station :
         stationsOf(*m_session.node().state(), m_changes.stations().target()))
        heaviest = std::max(heaviest, weightAt(station));
    return mostMilligrams(kind) / heaviest;
}

void GasModel::give(DrugKind kind, double mgPerKg)
{
    CARINA_EXPECTS(mgPerKg > 0.0);
    if (!obstacle().isEmpty())
        return;
    for (const StationId station :
         stationsOf(*m_session.node().state(), m_changes.stations().target())) {
        const double milligrams = std::min(mostMilligrams(kind), mgPerKg * weightAt(station));
        m_session.node().propose(station, fact::DrugGiven{{kind, milligrams}});
    }
}

QString GasModel::givenText() const
{
    const SessionTime now = m_session.node().now().value_or(SessionTime{});
    const Decided timeline{m_session, m_changes.stations().shown};
    QStringList texts;
    for (const GivenDose& given : timeline->dosesWithin(now - kShownDoses, SessionTime::max()))
        texts += doseText(given.dose);
    return texts.join(QStringLiteral(", "));
}

QString GasModel::tubeText() const
{
    const SessionTime now = m_session.node().now().value_or(SessionTime{});
    const Decided timeline{m_session, m_changes.stations().shown};
    if (!timeline->tube().isWatchedAt(now))
        return {};
    const QString place = seatText(timeline->tubePlaceAt(now).seat);
    return timeline->tube().isOverriddenAt(now)
               ? tr("▲ Tube: %1, as the console sets it, not as tracked").arg(place)
               : tr("Tube: %1, as tracked").arg(place);
}

QString GasModel::travellingText() const
{
    QStringList lines;
    for (std::size_t thing = 0; thing < kThings; ++thing)
        if (const auto& wanted = m_changes.pending(thing))
            lines << textOf(wanted->value);
    return lines.join(QLatin1Char('\n'));
}

QString GasModel::textOf(const Decision& decision)
{
    if (const auto* gas = std::get_if<GasSupply>(&decision))
        return tr("Gas → %1").arg(gasText(*gas));
    if (const auto* obstructed = std::get_if<double>(&decision))
        return *obstructed > 0.0 ? tr("Tube → obstructed by %1\u00a0%").arg(100.0 * *obstructed)
                                 : tr("Tube → open");
    if (const auto* tube = std::get_if<SetTube>(&decision))
        return tr("Tube → %1").arg(setTubeText(*tube));
    return std::get<bool>(decision) ? tr("Cuff → inflated") : tr("Cuff → empty");
}

void GasModel::set(const Decision& decision)
{
    const bool isOfTube = std::holds_alternative<bool>(decision);
    if ((isOfTube ? obstacleToTube() : obstacle()).isEmpty())
        m_changes.set(decision.index(), decision);
}

void GasModel::refresh()
{
    m_changes.follow();
    Shown now;
    for (std::size_t thing = 0; thing < kThings; ++thing) {
        now.decisions[thing] = m_changes.shown(thing);
        now.pending[thing] = m_changes.pending(thing).has_value();
    }
    now.given = givenText();
    now.tube = tubeText();
    now.obstacle = obstacle();
    now.obstacleToTube = obstacleToTube();
    now.weight_kg = weight_kg();
    now.hasTube = hasTube();
    now.hasStylet = hasStylet();
    now.canUndo = canUndo();
    if (std::exchange(m_shown, now) != now)
        Q_EMIT changed();
}

} // namespace carina
