#include "engine/tracking/igtl/igtl_client.h"

#include "engine/core/expects.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr std::size_t kMostReadByClient = 64 * 1024;
constexpr std::size_t kDeviceCharacters = 20;
constexpr std::size_t kOthersNamed = 8;
constexpr std::size_t kMostSent = 32;
constexpr Duration kSilence = std::chrono::seconds{2};
constexpr Duration kOverdue = std::chrono::milliseconds{500};
const std::string kOwnName = "Carina";

bool saysUnseen(const IgtlMessage& message)
{
    const auto status = std::ranges::find(message.metadata, "TransformStatus", &IgtlMetadata::key);
    return status != message.metadata.end() && status->value != "OK";
}

bool isSame(const RigidTransform& a, const RigidTransform& b)
{
    return a.translation() == b.translation() && a.rotation().coeffs() == b.rotation().coeffs();
}

/// A name from elsewhere, of which only what prints is shown.
std::string shownName(const std::string& name)
{
    std::string shown = name;
    std::ranges::replace_if(
        shown, [](char c) { return c < ' ' || c > '~'; }, '?');
    return shown;
}

} // namespace

IgtlClient::IgtlClient(IgtlClientSettings settings)
    : m_settings{std::move(settings)},
      m_reader{kMostReadByClient},
      m_tools(m_settings.devices.size())
{
    CARINA_EXPECTS(m_settings.rate_hz > 0);
    for (std::string& device : m_settings.devices)
        device = device.substr(0, kDeviceCharacters);
}

void IgtlClient::start(LocalTime now)
{
    m_reader = IgtlReader{kMostReadByClient};
    m_clock = {};
    std::ranges::fill(m_tools, Tool{});
    m_sent.clear();
    m_toSend.clear();
    m_now = m_begun = m_heard = m_asked = now;
    send({.version = 2, .device = kOwnName, .content = IgtlQuery{"GET_STATUS"}});
    if (m_settings.poses != IgtlPoses::Transform)
        send({.device = kOwnName,
              .content = IgtlStart{m_settings.poses == IgtlPoses::Qtdata,
                                   std::max(1, 1000 / m_settings.rate_hz),
                                   {}}});
}

void IgtlClient::send(const IgtlMessage& message)
{
    const auto bytes = encodeIgtl(message);
    m_toSend.insert(m_toSend.end(), bytes.begin(), bytes.end());
}

void IgtlClient::take(std::span<const std::byte> bytes, LocalTime now)
{
    m_now = now;
    m_heard = now;
    m_reader.take(bytes);
    while (const auto message = m_reader.next()) {
        if (*message)
            take(**message, now);
        else
            ++m_damaged;
    }
}

void IgtlClient::take(const IgtlMessage& message, LocalTime now)
{
    const bool isSeen = !saysUnseen(message);
    if (const auto* transform = std::get_if<IgtlTransform>(&message.content))
        take(message, message.device, isSeen, poseOf(transform->matrix), now);
    else if (const auto* position = std::get_if<IgtlPosition>(&message.content))
        take(message, message.device, isSeen, poseOf(*position), now);
    else if (const auto* tdata = std::get_if<IgtlTrackingData>(&message.content))
        for (const IgtlTracked& tool : tdata->tools)
            take(message, tool.name, isSeen, poseOf(tool.matrix), now);
    else if (const auto* qtdata = std::get_if<IgtlQuaternionTrackingData>(&message.content))
        for (const IgtlQuaternionTracked& tool : qtdata->tools)
            take(message, tool.name, isSeen, poseOf(tool), now);
}

void IgtlClient::take(const IgtlMessage& message, const std::string& name, bool isSeen,
                      const Result<RigidTransform>& pose, LocalTime now)
{
    if (m_sent.size() < kMostSent && std::ranges::find(m_sent, name) == m_sent.end())
        m_sent.push_back(name);
    const auto wanted = std::ranges::find(m_settings.devices, name);
    if (wanted == m_settings.devices.end())
        return;
    const auto index = static_cast<std::size_t>(wanted - m_settings.devices.begin());
    Tool& tool = m_tools[index];
    tool.refused = pose ? std::string{} : pose.error().detail;
    const bool isAgain = message.stamp != 0 && message.stamp == tool.stamp;
    if (isAgain && pose && tool.X_TO && isSame(*tool.X_TO, *pose) && isSeen == tool.isSeen)
        return; // a server that sends one pose for ever tells nothing of its tool
    tool.came = now;
    tool.isOverdue = false;
    if (!pose)
        return;
    IgtlSight sight{index, now};
    if (message.stamp != 0 && !isAgain)
        sight.exposed = m_clock.local(sinceEpoch(message.stamp), now);
    if (isSeen && !isPlaceholder(*pose))
        sight.X_TO = *pose;
    tool.stamp = message.stamp;
    tool.isSeen = isSeen;
    tool.X_TO = *pose;
    m_sights.push_back(sight);
}

std::vector<std::byte> IgtlClient::advance(LocalTime now)
{
    m_now = now;
    if (now - std::max(m_heard, m_asked) >= kSilence) {
        send({.device = kOwnName, .content = IgtlQuery{"GET_STATUS"}});
        m_asked = now;
    }
    m_wake = std::max(m_heard, m_asked) + kSilence;
    missOverdueTools();
    return std::exchange(m_toSend, {});
}

void IgtlClient::missOverdueTools()
{
    for (std::size_t i = 0; i < m_tools.size(); ++i) {
        Tool& tool = m_tools[i];
        if (!tool.came || tool.isOverdue)
            continue;
        const LocalTime due = *tool.came + kOverdue;
        tool.isOverdue = m_now >= due;
        if (tool.isOverdue)
            m_sights.push_back({i, due});
        else
            m_wake = std::min(m_wake, due);
    }
}

std::vector<IgtlSight> IgtlClient::takeSights() { return std::exchange(m_sights, {}); }

bool IgtlClient::isSilent() const { return m_now - m_heard >= kSilence; }

std::string IgtlClient::trouble() const
{
    if (m_reader.isLost())
        return "it does not speak OpenIGTLink";
    if (isSilent())
        return "it is silent";
    std::string missing;
    std::string refused;
    for (std::size_t i = 0; i < m_tools.size(); ++i) {
        const std::string name = shownName(m_settings.devices[i]);
        if (!m_tools[i].came && m_now - m_begun >= kSilence)
            missing += (missing.empty() ? "" : ", ") + name;
        else if (!m_tools[i].refused.empty())
            refused += (refused.empty() ? "" : "; ") + name + ": " + m_tools[i].refused;
    }
    if (missing.empty())
        return refused;
    return "it does not send " + missing + others();
}

/// What comes and is not wanted.
std::string IgtlClient::others() const
{
    std::string text;
    std::size_t named = 0;
    for (const std::string& name : m_sent) {
        if (std::ranges::find(m_settings.devices, name) != m_settings.devices.end())
            continue;
        if (++named > kOthersNamed)
            break;
        text += (text.empty() ? ", but " : ", ") + shownName(name);
    }
    return text;
}

std::vector<std::byte> IgtlClient::farewell() const
{
    if (m_settings.poses == IgtlPoses::Transform)
        return {};
    return encodeIgtl(
        {.device = kOwnName,
         .content = IgtlQuery{m_settings.poses == IgtlPoses::Qtdata ? "STP_QTDATA" : "STP_TDATA"}});
}

} // namespace carina
