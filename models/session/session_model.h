#pragma once

#include "engine/net/node/session_node.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <memory>

namespace carina
{

/// The phase and running time of a session, and the commands to start, pause and end it. Lives on
/// the GUI thread.
class SessionModel : public QObject
{
    Q_OBJECT

public:
    /// @pre node outlives this; nobody else listens to its changes.
    explicit SessionModel(SessionNode& node, QObject* parent = nullptr);
    ~SessionModel() override;

    [[nodiscard]] SessionNode& node() const { return m_node; }

    [[nodiscard]] QString name() const;
    [[nodiscard]] SessionPhase phase() const;
    /// The phase as a word: "Running".
    [[nodiscard]] static QString textOf(SessionPhase phase);
    /// Running time without pauses, in minutes and seconds: "04:12".
    [[nodiscard]] QString runningTimeText() const;

    /// What may be done next.
    [[nodiscard]] bool canStart() const; ///< or resume after a pause
    [[nodiscard]] bool canPause() const;
    [[nodiscard]] bool canEnd() const;

public Q_SLOTS:
    void start();
    void pause();
    void end();

Q_SIGNALS:
    /// The facts, the links or the pending proposals changed; at most once per event loop
    /// iteration.
    void changed();

private:
    void setPhase(SessionPhase phase);

    /// Outlives this where the node's thread still holds the callback.
    struct Wake;

    SessionNode& m_node;
    std::shared_ptr<Wake> m_wake; ///< shared with the callback on the node's thread
};

/// A running time in minutes and seconds: "04:12".
[[nodiscard]] QString timeText(Duration running);

} // namespace carina
