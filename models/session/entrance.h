#pragma once

#include "models/session/join_form.h"

#include <QObject>
#include <QTimer>

namespace carina
{

/// A person's way into a session: tries what they typed until the host has let them in, or says
/// what they have to mend. Lives on the GUI thread.
class Entrance : public QObject
{
    Q_OBJECT

public:
    using Join = std::function<Result<std::unique_ptr<SessionNode>>(const JoinSettings& settings)>;
    static constexpr int kInterval_ms = 50;
    /// After so many looks in vain the person is told where to look, too.
    static constexpr int kPatience = 100;
    /// After so many a name is believed to be taken: that of a program which was just killed is
    /// free again after 600 ms, and whoever started it anew need not touch anything.
    static constexpr int kTakenBelieved = 20;

    /// @param known what no form asks for
    explicit Entrance(JoinSettings known, Join join = SessionNode::join);

    /// @pre nothing is missing in the form.
    void enter(const JoinForm& form);
    /// Stops trying.
    void stop();
    /// Looks how far it is; called by itself.
    void look();

    [[nodiscard]] bool isTrying() const { return m_node && !isIn(); }
    [[nodiscard]] bool isIn() const;
    /// What it waits for, while it is trying.
    [[nodiscard]] QString progress() const;
    /// Why it was not let in, until the next try.
    [[nodiscard]] const std::optional<JoinGap>& refusal() const { return m_refusal; }
    /// As they were tried last.
    [[nodiscard]] const JoinSettings& settings() const { return m_settings; }
    /// The way in, which is the caller's from now on. @pre isIn()
    [[nodiscard]] std::unique_ptr<SessionNode> take();

Q_SIGNALS:
    void changed();

private:
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
