#include "engine/tracking/igtl/igtl_content.h"

#include "engine/core/expects.h"

namespace carina
{
namespace
{

constexpr std::size_t kToolName = 20;
constexpr std::size_t kTdataBytes = 70;
constexpr std::size_t kQtdataBytes = 50;
constexpr std::size_t kFrameName = 32;
constexpr std::size_t kStatusName = 20;
constexpr std::size_t kPointEntryBytes = 136;
constexpr std::size_t kPointName = 64;
constexpr std::size_t kPointGroup = 32;
constexpr std::size_t kPointOwner = 20;

/// A list of entries of one size that fills the body.
template <class Entry, class Read>
std::vector<Entry> entriesOf(IgtlBytes& bytes, std::size_t entryBytes, const Read& read)
{
    bytes.require(bytes.remaining() % entryBytes == 0, "size of the list");
    std::vector<Entry> entries;
    entries.reserve(bytes.remaining() / entryBytes);
    while (bytes.ok() && bytes.remaining() > 0)
        entries.push_back(read());
    return entries;
}

IgtlPosition readPosition(IgtlBytes& bytes)
{
    IgtlPosition position;
    position.p = bytes.reals<3>();
    position.terms = static_cast<int>(bytes.remaining() / sizeof(float));
    bytes.require(bytes.remaining() == 16 || bytes.remaining() == 12 || bytes.remaining() == 0,
                  "size of the quaternion");
    for (int i = 0; i < position.terms && bytes.ok(); ++i)
        position.q[static_cast<std::size_t>(i)] = bytes.real();
    return position;
}

IgtlTrackingData readTdata(IgtlBytes& bytes)
{
    return {entriesOf<IgtlTracked>(bytes, kTdataBytes, [&] {
        IgtlTracked tool;
        tool.name = bytes.field(kToolName);
        tool.type = bytes.number<std::uint8_t>();
        bytes.number<std::uint8_t>(); // reserved
        tool.matrix = bytes.reals<12>();
        return tool;
    })};
}

IgtlQuaternionTrackingData readQtdata(IgtlBytes& bytes)
{
    return {entriesOf<IgtlQuaternionTracked>(bytes, kQtdataBytes, [&] {
        IgtlQuaternionTracked tool;
        tool.name = bytes.field(kToolName);
        tool.type = bytes.number<std::uint8_t>();
        bytes.number<std::uint8_t>(); // reserved
        tool.p = bytes.reals<3>();
        tool.q = bytes.reals<4>();
        return tool;
    })};
}

IgtlStart readStart(IgtlBytes& bytes, bool asksQuaternions)
{
    IgtlStart start;
    start.asksQuaternions = asksQuaternions;
    start.interval_ms = bytes.number<std::int32_t>();
    start.frame = bytes.field(kFrameName);
    return start;
}

IgtlStatus readStatus(IgtlBytes& bytes)
{
    IgtlStatus status;
    status.code = bytes.number<std::uint16_t>();
    status.subcode = bytes.number<std::int64_t>();
    status.name = bytes.field(kStatusName);
    status.text = bytes.field(bytes.remaining());
    return status;
}

IgtlString readString(IgtlBytes& bytes)
{
    IgtlString string;
    string.encoding = bytes.number<std::uint16_t>();
    const auto length = bytes.number<std::uint16_t>();
    bytes.require(length == bytes.remaining(), "length of the text");
    string.text = bytes.bytes(length);
    return string;
}

IgtlPoints readPoints(IgtlBytes& bytes)
{
    return {entriesOf<IgtlPoint>(bytes, kPointEntryBytes, [&] {
        IgtlPoint point;
        point.name = bytes.field(kPointName);
        point.group = bytes.field(kPointGroup);
        for (std::uint8_t& part : point.rgba)
            part = bytes.number<std::uint8_t>();
        point.p = bytes.reals<3>();
        point.diameter = bytes.real();
        point.owner = bytes.field(kPointOwner);
        return point;
    })};
}

/// Writes the content that it is called with.
class ContentWriter
{
public:
    explicit ContentWriter(IgtlWriter& out) : m_out{out} {}

    void operator()(const IgtlTransform& transform) { m_out.reals(transform.matrix); }
    void operator()(const IgtlPosition& position)
    {
        m_out.reals(position.p);
        m_out.reals(std::span{position.q}.first(static_cast<std::size_t>(position.terms)));
    }
    void operator()(const IgtlTrackingData& data)
    {
        for (const IgtlTracked& tool : data.tools) {
            head(tool.name, tool.type);
            m_out.reals(tool.matrix);
        }
    }
    void operator()(const IgtlQuaternionTrackingData& data)
    {
        for (const IgtlQuaternionTracked& tool : data.tools) {
            head(tool.name, tool.type);
            m_out.reals(tool.p);
            m_out.reals(tool.q);
        }
    }
    void operator()(const IgtlStart& start)
    {
        m_out.number(start.interval_ms);
        m_out.field(start.frame, kFrameName);
    }
    void operator()(const IgtlStatus& status)
    {
        m_out.number(status.code);
        m_out.number(status.subcode);
        m_out.field(status.name, kStatusName);
        m_out.field(status.text, status.text.size() + 1);
    }
    void operator()(const IgtlString& string)
    {
        const std::string_view text = std::string_view{string.text}.substr(0, 0xFFFF);
        m_out.number(string.encoding);
        m_out.number(static_cast<std::uint16_t>(text.size()));
        m_out.bytes(text);
    }
    void operator()(const IgtlPoints& points)
    {
        for (const IgtlPoint& point : points.points) {
            m_out.field(point.name, kPointName);
            m_out.field(point.group, kPointGroup);
            for (const std::uint8_t part : point.rgba)
                m_out.number(part);
            m_out.reals(point.p);
            m_out.real(point.diameter);
            m_out.field(point.owner, kPointOwner);
        }
    }
    void operator()(const IgtlReply& reply) { m_out.number(reply.status); }
    void operator()(const IgtlQuery&) {}
    void operator()(const IgtlPolyData&) { CARINA_EXPECTS(false); }
    void operator()(const IgtlSkipped&) { CARINA_EXPECTS(false); }

private:
    void head(const std::string& name, std::uint8_t type)
    {
        m_out.field(name, kToolName);
        m_out.number(type);
        m_out.number(std::uint8_t{0});
    }

    IgtlWriter& m_out;
};

} // namespace

IgtlContent readSmallContent(const std::string& type, IgtlBytes& bytes)
{
    if (type == "TRANSFORM")
        return IgtlTransform{bytes.reals<12>()};
    if (type == "POSITION")
        return readPosition(bytes);
    if (type == "TDATA")
        return readTdata(bytes);
    if (type == "QTDATA")
        return readQtdata(bytes);
    if (type == "STT_TDATA" || type == "STT_QTDATA")
        return readStart(bytes, type == "STT_QTDATA");
    if (type == "STATUS")
        return readStatus(bytes);
    if (type == "STRING")
        return readString(bytes);
    if (type == "POINT")
        return readPoints(bytes);
    if (type.starts_with("RTS_"))
        return IgtlReply{type, bytes.number<std::int8_t>()};
    return IgtlQuery{type};
}

void writeSmallContent(IgtlWriter& out, const IgtlContent& content)
{
    std::visit(ContentWriter{out}, content);
}

} // namespace carina
