#include "models/session/entrance.h"

#include "engine/core/expects.h"

#include <algorithm>

namespace carina
{

Entrance::Entrance(JoinSettings known, Join join)
    : m_settings{std::move(known)}, m_join{std::move(join)}
{
    m_tick.callOnTimeout(this, &Entrance::look);
}

void Entrance::enter(const JoinForm& form)
{
    m_form = form;
    m_refusal.reset();
    m_looks = 0;
    fillIn(m_settings, form);
    auto node = m_join(m_settings);
    if (!node)
        return refuse(node.error());
    m_node = *std::move(node);
    m_tick.start(kInterval_ms);
    Q_EMIT changed();
}

void Entrance::stop()
{
    m_tick.stop();
    m_node.reset();
    Q_EMIT changed();
}

void Entrance::look()
{
    if (!m_node)
        return;
    ++m_looks;
    const auto why = m_node->refusal();
    if (isIn())
        m_tick.stop();
    else if (why && (why->code != Errc::NameTaken || m_looks >= kTakenBelieved))
        return refuse(*why);
    Q_EMIT changed();
}

bool Entrance::isIn() const { return m_node && m_node->self() != kNobody; }

/// Whether the host has let this program in, as its console then says.
bool Entrance::isConnected() const
{
    if (!m_node)
        return false;
    const auto links = m_node->links();
    return isIn() || std::ranges::any_of(links, [](const LinkReport& link) {
               return link.state == LinkState::Connected;
           });
}

QString Entrance::progress() const
{
    if (isConnected())
        return tr("Connected; waiting for the patient");
    if (!isTrying())
        return {};
    return m_looks < kPatience
               ? tr("Joining …")
               : tr(
                   "The instructor's computer has not answered yet, or this one is too busy. Wait, "
                   "or go back with Cancel and compare address and port with the instructor's "
                   "window.");
}

std::unique_ptr<SessionNode> Entrance::take()
{
    CARINA_EXPECTS(isIn());
    m_tick.stop();
    return std::move(m_node);
}

void Entrance::refuse(const Error& why)
{
    m_refusal = gapOf(why, m_form);
    stop();
}

} // namespace carina
