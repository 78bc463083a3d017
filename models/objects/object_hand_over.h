#pragma once

#include "models/session/change_history.h"
#include "models/session/session_model.h"

#include <QCoreApplication>
#include <QPointer>

namespace carina
{

/// Passes shared objects from one participant to another, lifts them out and puts them back. Each
/// of these is a change of the session's history, which gives the object back to whom it belonged.
/// Where somebody else got it since, or the host would refuse that, it stays where it is, and the
/// history says why.
class ObjectHandOver
{
    Q_DECLARE_TR_FUNCTIONS(carina::ObjectHandOver)

public:
    /// @param owner whose changes these are, in the history @pre both outlive this.
    ObjectHandOver(const QObject& owner, SessionNode& node) : m_owner{owner}, m_node{node} {}

    /// Adds them to a history from now on. @pre it takes nothing back once this is gone
    void setHistory(ChangeHistory& history) { m_history = &history; }

    /// Proposes the change. @param to kNobody puts it back into its place
    void pass(const SharedObject& object, ParticipantId to);

private:
    [[nodiscard]] QString textOf(const SharedObject& object, ParticipantId to) const;
    [[nodiscard]] SharedObject prospectOf(const SharedObject& object) const;
    void takeBack(ObjectId id, ParticipantId from, ParticipantId to);

    const QObject& m_owner;
    SessionNode& m_node;
    QPointer<ChangeHistory> m_history;
};

} // namespace carina
