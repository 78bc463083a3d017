#include "engine/tracking/igtl/igtl_subscriber.h"

#include "engine/tracking/igtl/igtl_pose.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr std::size_t kMostReadOfSubscriber = 64 * 1024;
constexpr std::size_t kMostQuestions = 16;
constexpr Duration kTimeToAsk = std::chrono::milliseconds{300};
constexpr Duration kIdle = std::chrono::seconds{2};
constexpr int kFastestCourse_ms = 10;
constexpr int kSlowestCourse_ms = 60'000;
const std::string kServerName = "Carina";

} // namespace

IgtlSubscriber::IgtlSubscriber(LocalTime connected)
    : m_reader{kMostReadOfSubscriber},
      m_connected{connected},
      m_surfaceDue{connected},
      m_sent{connected}
{
}

void IgtlSubscriber::take(std::span<const std::byte> bytes)
{
    m_reader.take(bytes);
    while (const auto message = m_reader.next())
        if (*message)
            take(**message);
}

void IgtlSubscriber::take(const IgtlMessage& message)
{
    m_version = std::max(m_version, message.version);
    if (const auto* start = std::get_if<IgtlStart>(&message.content)) {
        m_asks = true;
        const int interval =
            std::clamp<int>(start->interval_ms, kFastestCourse_ms, kSlowestCourse_ms);
        m_course = Course{start->asksQuaternions, std::chrono::milliseconds{interval}, {}};
        m_questions.emplace(start->asksQuaternions ? "RTS_QTDATA" : "RTS_TDATA", std::string{});
        return;
    }
    const auto* query = std::get_if<IgtlQuery>(&message.content);
    if (query == nullptr)
        return;
    if (query->type.starts_with("STP_")) {
        m_course.reset();
        return;
    }
    m_asks = m_asks || query->type != "GET_STATUS"; // which only asks whether this is alive
    if (m_questions.size() < kMostQuestions)
        m_questions.emplace(query->type, message.device);
}

std::vector<std::byte> IgtlSubscriber::due(const IgtlOffer& offer, LocalTime now)
{
    for (const Question& question : std::exchange(m_questions, {}))
        answer(question, offer);
    if (!m_asks && now - m_connected >= kTimeToAsk)
        push(offer, now);
    if (m_course && now >= m_course->next) {
        sendTools(offer, m_course->isQuaternions);
        const LocalTime next = m_course->next + m_course->interval;
        m_course->next = next > now ? next : now + m_course->interval;
    }
    if (m_out.empty() && now - m_sent >= kIdle)
        send(kServerName, 0, IgtlStatus{});
    if (!m_out.empty())
        m_sent = now;
    return std::exchange(m_out, {});
}

void IgtlSubscriber::answer(const Question& question, const IgtlOffer& offer)
{
    const auto& [type, device] = question;
    if (type == "GET_STATUS")
        send(kServerName, 0, IgtlStatus{});
    else if (type == "GET_POLYDATA" && offer.surface)
        send(device.empty() ? offer.surface->name : device, offer.surface->stamp,
             offer.surface->data);
    else if (type == "GET_POLYDATA")
        send(kServerName, 0, IgtlReply{"RTS_POLYDATA", 1});
    else if (type == "GET_POINT")
        send(device.empty() ? "Landmarks" : device, 0, *offer.landmarks);
    else if (type == "GET_TDATA" || type == "GET_QTDATA")
        sendTools(offer, type == "GET_QTDATA");
    else if (type == "GET_TRANS" || type == "GET_TRANSFORM") {
        for (const IgtlOffer::Tool& tool : offer.tools)
            if (device.empty() || device == tool.name)
                sendTool(offer, tool);
    } else if (type.starts_with("RTS_"))
        send(kServerName, 0, IgtlReply{type, 0});
}

void IgtlSubscriber::push(const IgtlOffer& offer, LocalTime now)
{
    if (offer.stamp != m_sentStamp)
        for (const IgtlOffer::Tool& tool : offer.tools)
            sendTool(offer, tool);
    m_sentStamp = offer.stamp;
    if (offer.landmarks != m_sentLandmarks && !offer.landmarks->points.empty())
        send("Landmarks", 0, *offer.landmarks);
    m_sentLandmarks = offer.landmarks;
    if (offer.surface && offer.surface != m_sentSurface && now >= m_surfaceDue) {
        send(offer.surface->name, offer.surface->stamp, offer.surface->data);
        m_sentSurface = offer.surface;
        m_surfaceDue = now + kSurfaceInterval;
    }
}

void IgtlSubscriber::sendTool(const IgtlOffer& offer, const IgtlOffer::Tool& tool)
{
    if (m_version < 2 && !tool.isSeen)
        return;
    send(tool.name, offer.stamp, IgtlTransform{igtlMatrix(tool.X_RO)},
         {{"TransformStatus", 3, tool.isSeen ? "OK" : "MISSING"}});
}

void IgtlSubscriber::sendTools(const IgtlOffer& offer, bool asQuaternions)
{
    IgtlTrackingData tdata;
    IgtlQuaternionTrackingData qtdata;
    for (const IgtlOffer::Tool& tool : offer.tools) {
        if (!tool.isSeen)
            continue;
        tdata.tools.push_back({tool.name, 1, igtlMatrix(tool.X_RO)});
        qtdata.tools.push_back(
            {tool.name, 1, igtlPoint(tool.X_RO.translation()), igtlQuaternion(tool.X_RO)});
    }
    if (asQuaternions)
        send(kServerName, offer.stamp, std::move(qtdata));
    else
        send(kServerName, offer.stamp, std::move(tdata));
}

void IgtlSubscriber::send(std::string device, std::uint64_t stamp, IgtlContent content,
                          std::vector<IgtlMetadata> metadata)
{
    const auto bytes = encodeIgtl(
        {m_version, std::move(device), stamp, ++m_id, std::move(metadata), std::move(content)});
    m_out.insert(m_out.end(), bytes.begin(), bytes.end());
}

} // namespace carina
