#pragma once

#include "models/session/join_form.h"

#include <QObject>
#include <QTimer>

namespace carina
{

/// Joins a session with what a person typed: tries until the host admits them, or reports what they
/// have to correct. Lives on the GUI thread.
class Entrance : public QObject
{
    Q_OBJECT

public:
    using Join = std::function<Result<std::unique_ptr<SessionNode>>(const JoinSettings& settings)>;
    static constexpr int kInterval_ms = 50;
    /// After this many unsuccessful polls progress() also advises to check address and port.
    static constexpr int kPatience = 100;
    /// NameTaken is accepted as final only after this many polls: the name of a program that was
    /// just killed becomes free after 600 ms, so that a restarted program joins by itself, and the
    /// host takes a second to see that two programs with one token are both alive.
    static constexpr int kTakenBelieved = 40;

    /// @param known settings that are not in the form
    explicit Entrance(JoinSettings known, Join join = SessionNode::join);

    /// @pre whatIsMissing() finds nothing in the form.
    void enter(const JoinForm& form);
    /// Stops joining.
    void stop();
    /// Polls the state of the connection; a timer calls it every kInterval_ms.
    void look();

    [[nodiscard]] bool isTrying() const { return m_node && !isIn(); }
    [[nodiscard]] bool isIn() const;
    /// A sentence on what it waits for while isTrying(), and what is waited for once isIn(); else
    /// empty.
    [[nodiscard]] QString progress() const;
    /// Why the host refused, until the next enter().
    [[nodiscard]] const std::optional<JoinGap>& refusal() const { return m_refusal; }
    /// The settings tried last.
    [[nodiscard]] const JoinSettings& settings() const { return m_settings; }
    /// The joined node; the caller owns it from now on. @pre isIn()
    [[nodiscard]] std::unique_ptr<SessionNode> take();

Q_SIGNALS:
    void changed();

private:
    [[nodiscard]] bool isConnected() const;
    void refuse(const Error& why);

    JoinSettings m_settings;
    Join m_join;
    JoinForm m_form;
    std::unique_ptr<SessionNode> m_node;
    std::optional<JoinGap> m_refusal;
    int m_looks = 0;
    QTimer m_tick;
};

} // namespace carina
