#pragma once

#include "engine/core/session_time.h"
#include "engine/tracking/ndi/ndi_command.h"
#include "engine/tracking/ndi/ndi_reply.h"

#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carina
{

/// What is to be done at the port now, in this order.
struct NdiPortAction {
    std::optional<int> rate{}; ///< set the host's rate
    bool sendBreak = false;
    std::string bytes{}; ///< to send
};

/// One command, how long its reply may take, and what follows from it.
struct NdiStep {
    NdiCommand command{}; ///< without a name: only waits, for all of the patience
    Duration patience{};
    std::function<void(const NdiReply&)> then{};
    std::function<void()> inVain{}; ///< without it the device counts as silent
    bool isReset = false;           ///< answered by RESET
    bool isRepeatable = false;      ///< in vain as soon as the line is quiet behind a damaged reply
    bool sendsBreak = false;
    std::optional<int> rate{}; ///< of the host's port from now on

    [[nodiscard]] bool asks() const { return isReset || !command.name.empty(); }
};

/// Commands to a tracker of NDI, one after another: each is sent when the one before was answered,
/// or was not in its time. Without port and clock. What follows from a reply may queue more.
class NdiDialogue
{
public:
    struct Events {
        std::function<void()> wasReset; ///< the device says so, and was not asked to
        std::function<void()> isSilent; ///< a command was not answered
    };

    explicit NdiDialogue(Events events) : m_events{std::move(events)} {}

    /// Forgets what is queued and what is arriving.
    void clear(LocalTime now);
    /// Forgets what is queued only.
    void dropSteps() { m_steps.clear(); }
    void queue(NdiStep step) { m_steps.push_back(std::move(step)); }
    /// In front of what is queued, in the order of the list.
    void queueFirst(std::vector<NdiStep> steps);

    /// Bytes that have arrived.
    void take(std::span<const std::byte> bytes, LocalTime now);
    [[nodiscard]] NdiPortAction advance(LocalTime now);
    [[nodiscard]] LocalTime nextWake() const { return m_wake; }

    /// How long the reply that is being handled took on a serial line, 10 bits a byte.
    [[nodiscard]] Duration replyTime() const { return wireTime(m_replyBytes); }
    /// How long so many bytes take on a serial line.
    [[nodiscard]] Duration wireTime(std::size_t bytes) const;
    /// Replies that were damaged, since the construction.
    [[nodiscard]] std::size_t damagedReplies() const { return m_damaged; }

private:
    void takeReply(const NdiReply& reply, LocalTime now);
    void takeDamage(LocalTime now);
    void endInVain(LocalTime now);
    void endStep(LocalTime now);
    [[nodiscard]] bool waits() const;

    Events m_events;
    NdiReplyReader m_reader;
    std::deque<NdiStep> m_steps;
    std::optional<LocalTime> m_deadline; ///< of the step that is under way; nothing: not begun
    std::optional<LocalTime> m_quiet;    ///< when a step with a damaged reply ends before that
    LocalTime m_wake{};
    int m_bitsPerSecond = 9600;
    std::size_t m_replyBytes = 0; ///< of the reply that is arriving
    std::size_t m_damaged = 0;
};

} // namespace carina
