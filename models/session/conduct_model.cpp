#include "models/session/conduct_model.h"

#include "engine/session/conduct_rules.h"
#include "engine/session/facts/fact_rules.h"
#include "models/session/propose_back.h"
#include "models/session/proposed.h"

#include <utility>

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
    if (m_history)
        m_history->add(*this, muted ? tr("%1 → muted").arg(name) : tr("%1 → not muted").arg(name),
                       [this, participant, muted] { takeBackMute(participant, muted); });
    decide(fact::ParticipantMuted{participant, muted});
}

/// What is under way is judged by the host before what takes it back.
void ConductModel::takeBackMute(ParticipantId participant, bool muted)
{
    const fact::ParticipantMuted back{participant, !muted};
    const bool isUnderWay = isProposed<fact::ParticipantMuted>(
        m_session.node(), [participant](const fact::ParticipantMuted& proposed) {
            return proposed.participant == participant;
        });
    proposeBack(m_session.node(), kNoStation, back, isUnderWay ? QString{} : whyMuteStays(back),
                m_history);
}

/// Empty where it can be taken back.
QString ConductModel::whyMuteStays(const fact::ParticipantMuted& back) const
{
    const Standing standing = standingOf(back.participant);
    if (standing.isMuted == back.muted)
        return standing.isMuted
                   ? tr("Nothing to undo: %1 is muted again.").arg(standing.name)
                   : tr("Nothing to undo: %1 is not muted any more.").arg(standing.name);
    const auto state = m_session.node().state();
    const auto may = checkNamed(*state, back).and_then([&] { return checkConduct(*state, back); });
    return may ? QString{} : tr("Not undone: nobody but %1 instructs now.").arg(standing.name);
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
                       [this, locked] { takeBackLock(locked); });
    decide(fact::SessionLocked{locked});
}

void ConductModel::takeBackLock(bool locked)
{
    const bool isUnderWay = isProposed<fact::SessionLocked>(
        m_session.node(), [](const fact::SessionLocked& /*any*/) { return true; });
    proposeBack(m_session.node(), kNoStation, fact::SessionLocked{!locked},
                isUnderWay ? QString{} : whyLockStays(locked), m_history);
}

QString ConductModel::whyLockStays(bool locked) const
{
    if (isLocked() == locked)
        return {};
    return isLocked() ? tr("Nothing to undo: the session is locked again.")
                      : tr("Nothing to undo: the session is not locked any more.");
}

void ConductModel::changeCode(Role role) { decide(fact::RoleCodeChanged{role}); }

void ConductModel::decide(FactBody body) { m_session.node().propose(kNoStation, std::move(body)); }

} // namespace carina
