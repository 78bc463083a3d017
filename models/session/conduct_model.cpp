#include "models/session/conduct_model.h"

#include "engine/session/facts/fact_rules.h"

namespace carina
{
namespace
{

constexpr ParticipantId kHostingParticipant{0};

} // namespace

ConductModel::ConductModel(SessionModel& session, QObject* parent)
    : QObject{parent}, m_session{session}
{
    connect(&m_session, &SessionModel::changed, this, &ConductModel::changed);
}

ConductModel::Standing ConductModel::standingOf(ParticipantId participant) const
{
    const auto state = m_session.node().state();
    const auto known = state->participants().find(participant);
    if (known == state->participants().end())
        return {};
    const Participant& who = known->second;
    const bool isNeeded =
        participant == kHostingParticipant || participant == m_session.node().self();
    Standing standing;
    standing.name = QString::fromStdString(who.name);
    standing.role = who.role;
    standing.isMuted = who.muted;
    standing.isBanned = who.removal && who.removal->banned;
    standing.canMute = !isNeeded && (who.present || who.muted);
    standing.canRemove = !isNeeded && !standing.isBanned;
    return standing;
}

bool ConductModel::isLocked() const { return m_session.node().state()->isLocked(); }

bool ConductModel::isShortEnough(const QString& reason)
{
    return static_cast<std::size_t>(reason.toUtf8().size()) <= kLongestText;
}

void ConductModel::setMuted(ParticipantId participant, bool muted)
{
    const QString name = standingOf(participant).name;
    const auto takeBack = [this, participant, muted] {
        if (standingOf(participant).isMuted == muted) // else somebody decided since
            decide(fact::ParticipantMuted{participant, !muted});
    };
    if (m_history)
        m_history->add(*this, muted ? tr("%1 → muted").arg(name) : tr("%1 → not muted").arg(name),
                       takeBack);
    decide(fact::ParticipantMuted{participant, muted});
}

void ConductModel::remove(ParticipantId participant, const QString& reason, bool ban)
{
    decide(fact::ParticipantRemoved{participant, ban, reason.toStdString()});
}

void ConductModel::letBack(ParticipantId participant) { decide(fact::BanLifted{participant}); }

void ConductModel::setLocked(bool locked)
{
    if (m_history)
        m_history->add(*this, locked ? tr("Session → locked") : tr("Session → unlocked"),
                       [this, locked] {
                           if (isLocked() == locked)
                               decide(fact::SessionLocked{!locked});
                       });
    decide(fact::SessionLocked{locked});
}

void ConductModel::changeCode(Role role) { decide(fact::RoleCodeChanged{role}); }

void ConductModel::decide(FactBody body) { m_session.node().propose(kNoStation, std::move(body)); }

} // namespace carina
