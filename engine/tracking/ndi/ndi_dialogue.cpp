#include "engine/tracking/ndi/ndi_dialogue.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace carina
{
namespace
{

constexpr Duration kIdleWake = std::chrono::milliseconds{500};
constexpr Duration kQuiet = std::chrono::milliseconds{5};
constexpr int kBitsPerByte = 10;

} // namespace

void NdiDialogue::clear(LocalTime now)
{
    m_reader.clear();
    m_replyBytes = 0;
    m_steps.clear();
    endStep(now);
}

void NdiDialogue::queueFirst(std::vector<NdiStep> steps)
{
    m_steps.insert(m_steps.begin(), std::move_iterator{steps.begin()},
                   std::move_iterator{steps.end()});
}

void NdiDialogue::take(std::span<const std::byte> bytes, LocalTime now)
{
    if (m_quiet)
        m_quiet = now + kQuiet; // the rest of what was damaged
    m_replyBytes += bytes.size();
    m_reader.take(bytes);
    while (const auto reply = m_reader.next()) {
        if (*reply)
            takeReply(**reply, now);
        else
            takeDamage(now);
        m_replyBytes = 0;
    }
}

/// The reply to a step is lost; the step ends with its patience, or sooner.
void NdiDialogue::takeDamage(LocalTime now)
{
    ++m_damaged;
    if (waits() && m_steps.front().isRepeatable)
        m_quiet = now + kQuiet;
}

bool NdiDialogue::waits() const { return m_deadline && !m_steps.empty() && m_steps.front().asks(); }

void NdiDialogue::endStep(LocalTime now)
{
    m_deadline.reset();
    m_quiet.reset();
    m_wake = now;
}

void NdiDialogue::takeReply(const NdiReply& reply, LocalTime now)
{
    const bool isReset = reply.bytes == "RESET";
    if (isReset && !(waits() && m_steps.front().isReset))
        return m_events.wasReset();
    if (!waits() || isReset != m_steps.front().isReset)
        return; // too late, or of nobody
    const NdiStep step = std::move(m_steps.front());
    m_steps.pop_front();
    endStep(now);
    if (step.then)
        step.then(reply);
}

void NdiDialogue::endInVain(LocalTime now)
{
    const NdiStep step = std::move(m_steps.front());
    m_steps.pop_front();
    endStep(now);
    m_reader.clear();
    m_replyBytes = 0;
    if (step.inVain)
        step.inVain();
    else if (step.asks())
        m_events.isSilent();
}

NdiPortAction NdiDialogue::advance(LocalTime now)
{
    NdiPortAction action;
    while (!m_steps.empty()) {
        const auto end = m_quiet ? std::min(m_deadline, m_quiet) : m_deadline;
        if (end && now < *end) {
            m_wake = *end;
            return action;
        }
        if (end) {
            endInVain(now);
            continue;
        }
        const NdiStep& step = m_steps.front();
        m_deadline = now + step.patience;
        if (step.rate) {
            action.rate = step.rate;
            m_bitsPerSecond = *step.rate;
        }
        action.sendBreak = action.sendBreak || step.sendsBreak;
        if (!step.command.name.empty())
            action.bytes += encoded(step.command);
    }
    m_wake = now + kIdleWake;
    return action;
}

Duration NdiDialogue::wireTime(std::size_t bytes) const
{
    return std::chrono::nanoseconds{std::int64_t(bytes) * kBitsPerByte * 1'000'000'000
                                    / m_bitsPerSecond};
}

} // namespace carina
