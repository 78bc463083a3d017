#pragma once

#include "engine/net/node/session_node.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <memory>

namespace carina
{

/// The session as a person starts, pauses and ends it. Lives on the GUI thread.
class SessionModel : public QObject
{
    Q_OBJECT

public:
    /// @pre node outlives this; it is the only one to listen to its changes.
    explicit SessionModel(SessionNode& node, QObject* parent = nullptr);
    ~SessionModel() override;

    [[nodiscard]] SessionNode& node() const { return m_node; }

    [[nodiscard]] QString name() const;
    [[nodiscard]] SessionPhase phase() const;
    /// The phase as a word: "Running".
    [[nodiscard]] QString phaseText() const;
    /// Time spent running, pauses left out, as minutes and seconds: "04:12".
    [[nodiscard]] QString runningTimeText() const;

    /// What may be done next.
    [[nodiscard]] bool canStart() const; ///< also: may go on after a pause
    [[nodiscard]] bool canPause() const;
    [[nodiscard]] bool canEnd() const;

public Q_SLOTS:
    void start();
    void pause();
    void end();

Q_SIGNALS:
    /// The facts, the links or what is under way changed; at most once per turn of the event loop.
    void changed();

private:
    void setPhase(SessionPhase phase);

    /// Outlives this where the node's thread still holds the callback.
    struct Wake;

    SessionNode& m_node;
    std::shared_ptr<Wake> m_wake; ///< shared with the callback on the node's thread
};

} // namespace carina
