#include "models/airway/head_position_model.h"

#include "engine/core/expects.h"
#include "models/airway/head_positions.h"

#include <QTimer>

#include <utility>

namespace carina
{
namespace
{

/// How often a change under way is looked for; nothing signals the moment a fact takes effect.
constexpr int kHeadLook_ms = 50;

} // namespace

HeadPositionModel::HeadPositionModel(SessionModel& session, StationId station, QObject* parent)
    : QObject{parent}, m_session{session}, m_changes{session, station, *this, quantities()}
{
    connect(&m_session, &SessionModel::changed, this, &HeadPositionModel::refresh);
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &HeadPositionModel::refresh);
    timer->start(kHeadLook_ms);
}

HeadPositionModel::Changes::Quantities HeadPositionModel::quantities()
{
    return {.decidedAt =
                [this](StationId id, std::size_t /*head*/, SessionTime t) {
                    const auto state = m_session.node().state();
                    const auto station = state->stations().find(id);
                    return station == state->stations().end()
                               ? HeadPosition{}
                               : station->second.headPosition.decidedAt(t);
                },
            .propose =
                [this](std::size_t /*head*/, const Changes::Setting& setting) {
                    m_session.node().propose(setting.station,
                                             fact::HeadPositionSet{setting.value, setting.over});
                },
            .textOf = [](std::size_t /*head*/,
                         const HeadPosition& position) { return textOf(position); },
            .requested = [this] { Q_EMIT changed(); }};
}

void HeadPositionModel::setStation(StationId station)
{
    if (!m_changes.setStation(station))
        return;
    refresh();
    Q_EMIT changed();
}

HeadPosition HeadPositionModel::present() const
{
    const auto state = m_session.node().state();
    const auto station = state->stations().find(m_changes.stations().shown);
    const SessionTime now = m_session.node().now().value_or(SessionTime{});
    return station == state->stations().end() ? HeadPosition{}
                                              : headPositionAt(station->second, now);
}

void HeadPositionModel::setPosition(const HeadPosition& position)
{
    CARINA_EXPECTS(withinReach(position) == position);
    if (obstacle().isEmpty())
        m_changes.set(kHead, position, m_over);
}

QString HeadPositionModel::inForceText() const { return headFiguresText(present()); }

QString HeadPositionModel::travellingText() const
{
    const auto& pending = m_changes.pending(kHead);
    return pending ? textOf(pending->value) : QString{};
}

QString HeadPositionModel::textOf(const HeadPosition& position)
{
    return tr("Head position → %1").arg(headPositionText(position));
}

void HeadPositionModel::refresh()
{
    m_changes.follow();
    Shown shownNow{position(), present(), m_changes.pending(kHead).has_value(), obstacle(),
                   canUndo()};
    if (std::exchange(m_shown, shownNow) != shownNow)
        Q_EMIT changed();
}

} // namespace carina
