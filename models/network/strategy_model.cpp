#include "models/network/strategy_model.h"

namespace carina
{

StrategyModel::StrategyModel(SessionModel& session, QObject* parent)
    : QObject{parent}, m_session{session}
{
    connect(&m_session, &SessionModel::changed, this, &StrategyModel::changed);
}

std::vector<StrategyModel::Entry> StrategyModel::entries()
{
    return {
        {StrategyKind::SessionClock, tr("Session clock"),
         tr("Every action is dated on one clock and repeated until it has arrived: as near as the "
            "clock is right to what is possible for viewers who go on with the old motion until "
            "they hear. The usual one.")},
        {StrategyKind::LocalLag, tr("Local lag"),
         tr("As the session clock, but every action begins a little later, for the person who acts "
            "as well: when it has arrived at everyone who may act, at the latest after the longest "
            "lag. Where messages need less time than that, there is no drift.")},
        {StrategyKind::AsaAdaptive, tr("ASA, adaptive"),
         tr("The Adaptive Synchronization Algorithm of 2004: an action that arrives is advanced by "
            "half the round trip, which is measured more often while it varies.")},
        {StrategyKind::AsaFixed, tr("ASA, fixed"),
         tr("The same, with the round trip measured at a fixed rate.")},
        {StrategyKind::DeadReckoning, tr("Dead reckoning"),
         tr("Distributed Interactive Simulation: a new state is sent when the old one, "
            "extrapolated, is off by 3 degrees or 1 m.")},
        {StrategyKind::Interpolation, tr("Interpolation"),
         tr("60 poses a second are sent. Each viewer draws a moment that lies a little back, "
            "between "
            "the two poses around it.")},
        {StrategyKind::Event, tr("Event"),
         tr("An action brings the pose it starts from, and begins when it arrives: late by the "
            "delay.")},
        {StrategyKind::None, tr("None"),
         tr("An action moves an object from wherever it is; errors are never corrected.")},
    };
}

StrategyChoice StrategyModel::chosen() const { return m_session.node().state()->strategy(); }

QString StrategyModel::chosenName() const
{
    for (const Entry& entry : entries())
        if (entry.kind == chosen().kind)
            return entry.name;
    return {};
}

void StrategyModel::choose(const StrategyChoice& choice)
{
    if (choice != chosen())
        m_session.node().propose(kNoStation, fact::StrategyChosen{choice});
}

} // namespace carina
