#include "engine/sync/connection/loss_window.h"

#include "engine/sync/wire/sequence.h"

#include <algorithm>

namespace carina
{

void LossWindow::arrived(std::uint32_t sequence)
{
    if (m_sent == 0) {
        m_newest = sequence;
        m_sent = 1;
    } else if (isAfter(sequence, m_newest)) {
        goOnTo(sequence);
    } else if (m_newest - sequence >= m_sent) {
        return; // sent before the window began
    }
    m_arrived.set(sequence % kWindow);
}

void LossWindow::goOnTo(std::uint32_t sequence)
{
    const std::uint32_t sent = sequence - m_newest;
    for (std::uint32_t next = 1; next <= std::min(sent, kWindow); ++next)
        m_arrived.reset((m_newest + next) % kWindow);
    m_sent = std::min(m_sent + sent, kWindow);
    m_newest = sequence;
}

std::optional<double> LossWindow::loss() const
{
    if (m_sent < kLeast)
        return std::nullopt;
    return 1.0 - static_cast<double>(m_arrived.count()) / static_cast<double>(m_sent);
}

} // namespace carina
