#pragma once

#include "engine/tracking/ndi/ndi_checksum.h"
#include "engine/tracking/ndi/ndi_client.h"
#include "tests/engine/tracking/ndi/wire_bytes.h"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace carina::test
{

/// A text as a device of NDI sends it, with checksum and CR.
inline std::string textReply(const std::string& content)
{
    return content + ndiChecksumText(content) + "\r";
}

/// The body of a reply to BX as a device sends it, with header and checksums.
inline std::string binaryReply(const WireBytes& body)
{
    const WireBytes header = WireBytes{}.u16(0xA5C4).u16(body.size());
    return header.text() + WireBytes{}.u16(ndiChecksum(header.text())).text() + body.text()
           + WireBytes{}.u16(ndiChecksum(body.text())).text();
}

/// A client and a device that answers by a script, at the two ends of a line, in virtual time.
class ScriptedLine
{
public:
    /// The reply to a command, both whole as they are on the line; empty where there is none. A
    /// break of the line is an empty command.
    using Answer = std::function<std::string(const std::string& command, LocalTime now)>;

    /// @param delay from each command to the last byte of its reply
    ScriptedLine(NdiClientSettings settings, Duration delay, Answer answer)
        : m_client{std::move(settings)}, m_delay{delay}, m_answer{std::move(answer)}
    {
    }

    [[nodiscard]] NdiClient& client() { return m_client; }
    /// All commands, whole, in the order in which they were sent.
    [[nodiscard]] const std::vector<std::string>& sent() const { return m_sent; }

    void start()
    {
        m_client.start(m_now);
        act();
    }

    /// @returns the measurements in this time.
    std::vector<NdiMeasurement> run(Duration time)
    {
        const LocalTime end = m_now + time;
        std::vector<NdiMeasurement> measured;
        while (m_now < end) {
            LocalTime next = std::min(end, m_client.nextWake());
            for (const Reply& reply : m_underWay)
                next = std::min(next, reply.at);
            m_now = std::max<LocalTime>(next, m_now + std::chrono::microseconds{1});
            deliver();
            act();
            for (NdiMeasurement& each : m_client.takeMeasurements())
                measured.push_back(std::move(each));
        }
        return measured;
    }

private:
    struct Reply {
        std::string bytes;
        LocalTime at{};
    };

    void deliver()
    {
        std::string arrived;
        for (const Reply& reply : m_underWay)
            if (reply.at <= m_now)
                arrived += reply.bytes;
        std::erase_if(m_underWay, [this](const Reply& reply) { return reply.at <= m_now; });
        if (!arrived.empty())
            m_client.take(std::as_bytes(std::span{arrived}), m_now);
    }

    void act()
    {
        const NdiPortAction action = m_client.advance(m_now);
        if (action.sendBreak)
            answer({});
        if (action.bytes.empty())
            return;
        m_sent.push_back(action.bytes);
        answer(action.bytes);
    }

    void answer(const std::string& command)
    {
        std::string reply = m_answer(command, m_now);
        if (!reply.empty())
            m_underWay.push_back({std::move(reply), m_now + m_delay});
    }

    LocalTime m_now{std::chrono::seconds{10}};
    NdiClient m_client;
    Duration m_delay;
    Answer m_answer;
    std::vector<Reply> m_underWay;
    std::vector<std::string> m_sent;
};

} // namespace carina::test
