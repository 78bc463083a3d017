#pragma once

#include "models/session/change_history.h"
#include "models/session/session_model.h"

#include <QPointer>

namespace carina
{

/// What an instructor decides about who takes part: mute, remove, ban, lock, and a role's new code.
/// Lives on the GUI thread.
class ConductModel : public QObject
{
    Q_OBJECT

public:
    /// What can be decided about one participant.
    struct Standing {
        QString name{};
        Role role = Role::Observer;
        bool isMuted = false;
        bool isBanned = false;
        bool canMute = false; ///< or unmute
        bool canRemove = false;

        friend bool operator==(const Standing&, const Standing&) = default;
    };

    /// @pre session outlives this.
    explicit ConductModel(SessionModel& session, QObject* parent = nullptr);

    /// Nothing can be decided about an unknown participant, the host and this program's own.
    [[nodiscard]] Standing standingOf(ParticipantId participant) const;
    [[nodiscard]] bool isLocked() const;

    /// Adds what is muted and locked to a history from now on. What somebody decided otherwise
    /// since, or the host would refuse, is not taken back, and the history says why.
    void setHistory(ChangeHistory& history) { m_history = &history; }

    /// Whether a reason for a removal fits into its fact.
    [[nodiscard]] static bool isShortEnough(const QString& reason);

    void setMuted(ParticipantId participant, bool muted);
    /// @pre isShortEnough(reason)
    void remove(ParticipantId participant, const QString& reason, bool ban);
    void letBack(ParticipantId participant);
    void setLocked(bool locked);
    void changeCode(Role role);

Q_SIGNALS:
    /// What can be decided may have changed.
    void changed();

private:
    void decide(FactBody body);
    void takeBackMute(ParticipantId participant, bool muted);
    void takeBackLock(bool locked);
    [[nodiscard]] QString whyMuteStays(const fact::ParticipantMuted& back) const;
    [[nodiscard]] QString whyLockStays(bool locked) const;

    SessionModel& m_session;
    QPointer<ChangeHistory> m_history;
};

} // namespace carina
