#include "models/physiology/hands_model.h"

#include "engine/lungs/mechanics/respiratory_system.h"

#include <QTimer>

#include <utility>

namespace carina
{
namespace
{

/// How often a change under way is looked for; nothing signals the moment a fact takes effect.
constexpr int kHandsLook_ms = 50;

QString bagText(bool squeezed)
{
    return squeezed ? HandsModel::tr("Bag → squeezed") : HandsModel::tr("Bag → let go");
}

} // namespace

HandsModel::HandsModel(SessionModel& session, StationId station, QObject* parent)
    : QObject{parent},
      m_session{session},
      m_gas{session, station},
      m_bag{session, station, *this, quantities()}
{
    connect(&m_gas, &GasModel::changed, this, &HandsModel::changed);
    connect(&m_session, &SessionModel::changed, this, &HandsModel::refresh);
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &HandsModel::refresh);
    timer->start(kHandsLook_ms);
}

HandsModel::BagChanges::Quantities HandsModel::quantities()
{
    return {.decidedAt =
                [this](StationId station, std::size_t /*thing*/, SessionTime t) {
                    return settingsAt(station, t).bag.rate > Frequency{};
                },
            .propose =
                [this](std::size_t /*thing*/, const BagChanges::Setting& setting) {
                    m_session.node().propose(
                        setting.station, fact::BagSqueezed{bagOf(setting.station, setting.value)});
                },
            .textOf = [](std::size_t /*thing*/, bool squeezed) { return bagText(squeezed); },
            .requested = [this] { Q_EMIT changed(); }};
}

void HandsModel::setStation(StationId station)
{
    m_gas.setStation(station);
    m_bag.setStation(station);
    refresh();
}

RespiratorySettings HandsModel::settingsAt(StationId id, SessionTime t) const
{
    const auto state = m_session.node().state();
    const auto station = state->stations().find(id);
    return station == state->stations().end() ? RespiratorySettings{}
                                              : station->second.respiration.settingsAt(t);
}

/// One that is let go keeps its volume.
HandBag HandsModel::bagOf(StationId station, bool squeezed) const
{
    const RespiratorySettings settings = settingsAt(station, SessionTime::max());
    if (!squeezed)
        return {{}, settings.bag.tidalVolume};
    const BreathingPattern quiet = restingPattern(settings.build);
    return {quiet.rate, quiet.tidalVolume};
}

void HandsModel::squeezeBag(bool squeezed)
{
    if (obstacleToBag().isEmpty())
        m_bag.set(0, squeezed);
}

QString HandsModel::obstacleToBag() const
{
    if (const QString obstacle = this->obstacle(); !obstacle.isEmpty())
        return obstacle;
    const auto state = m_session.node().state();
    const ParticipantId self = m_session.node().self();
    const ParticipantId worker = state->atWork(m_bag.stations().shown);
    if (worker == self || state->participants().at(self).role == Role::Instructor)
        return {};
    const auto other = state->participants().find(worker);
    if (other == state->participants().end())
        return tr("To squeeze the bag, take up the work at the patient.");
    return tr("%1 is at work here and squeezes the bag.")
        .arg(QString::fromStdString(other->second.name));
}

QString HandsModel::travellingText() const
{
    QStringList lines;
    if (const QString cuff = m_gas.travellingText(); !cuff.isEmpty())
        lines << cuff;
    if (const auto& bag = m_bag.pending(0))
        lines << bagText(bag->value);
    return lines.join(QLatin1Char('\n'));
}

void HandsModel::refresh()
{
    m_bag.follow();
    const Shown now{isBagSqueezed(), obstacleToBag(), travellingText()};
    if (std::exchange(m_shown, now) != now)
        Q_EMIT changed();
}

} // namespace carina
