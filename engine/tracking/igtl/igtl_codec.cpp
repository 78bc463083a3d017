#include "engine/tracking/igtl/igtl_codec.h"

#include "engine/core/expects.h"
#include "engine/tracking/igtl/igtl_checksum.h"
#include "engine/tracking/igtl/igtl_content.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr std::size_t kTypeName = 12;
constexpr std::size_t kDeviceName = 20;
constexpr std::uint16_t kExtensionBytes = 12;
constexpr std::size_t kMetadataEntryBytes = 8;
constexpr std::array kReadTypes{"TRANSFORM",  "POSITION",   "TDATA",       "QTDATA", "STT_TDATA",
                                "STT_QTDATA", "STATUS",     "STRING",      "POINT",  "POLYDATA",
                                "RTS_TDATA",  "RTS_QTDATA", "RTS_POLYDATA"};

tl::unexpected<Error> damaged(const std::string& type, const char* what)
{
    return fail(Errc::DeviceReplyDamaged, type + ": " + what);
}

std::vector<IgtlMetadata> readMetadata(IgtlBytes heads, IgtlBytes words, bool& isRight)
{
    const std::size_t count = heads.number<std::uint16_t>();
    heads.require(heads.remaining() == count * kMetadataEntryBytes, "metadata");
    std::vector<IgtlMetadata> metadata;
    metadata.reserve(heads.ok() ? count : 0);
    for (std::size_t i = 0; i < count && heads.ok() && words.ok(); ++i) {
        const auto keyBytes = heads.number<std::uint16_t>();
        IgtlMetadata entry;
        entry.encoding = heads.number<std::uint16_t>();
        const auto valueBytes = heads.number<std::uint32_t>();
        entry.key = words.bytes(keyBytes);
        entry.value = words.bytes(valueBytes);
        metadata.push_back(std::move(entry));
    }
    isRight = heads.ok() && words.ok() && words.remaining() == 0;
    return metadata;
}

/// Splits a body of version 2, which is extension, content, metadata.
/// @returns the content
IgtlBytes readExtended(IgtlBytes& bytes, IgtlMessage& message)
{
    const std::size_t whole = bytes.remaining();
    const auto extension = bytes.number<std::uint16_t>();
    const auto heads = bytes.number<std::uint16_t>();
    const auto words = bytes.number<std::uint32_t>();
    message.id = bytes.number<std::uint32_t>();
    bytes.require(extension >= kExtensionBytes && std::uint64_t{extension} + heads + words <= whole,
                  "sizes of the extended header");
    if (!bytes.ok())
        return bytes;
    bytes.part(extension - kExtensionBytes); // of a later version
    IgtlBytes content = bytes.part(bytes.remaining() - heads - words);
    if (heads > 0) {
        bool isRight = true;
        const IgtlBytes headPart = bytes.part(heads);
        message.metadata = readMetadata(headPart, bytes.part(words), isRight);
        bytes.require(isRight, "metadata");
    } else {
        bytes.require(words == 0, "metadata");
    }
    return content;
}

void writeMetadata(IgtlWriter& out, const std::vector<IgtlMetadata>& metadata)
{
    out.number(static_cast<std::uint16_t>(metadata.size()));
    for (const IgtlMetadata& entry : metadata) {
        out.number(static_cast<std::uint16_t>(entry.key.size()));
        out.number(entry.encoding);
        out.number(static_cast<std::uint32_t>(entry.value.size()));
    }
    for (const IgtlMetadata& entry : metadata) {
        out.bytes(entry.key);
        out.bytes(entry.value);
    }
}

void writeContent(IgtlWriter& out, const IgtlContent& content)
{
    if (const auto* surface = std::get_if<IgtlPolyData>(&content))
        writePolyData(out, *surface);
    else
        writeSmallContent(out, content);
}

std::vector<std::byte> bodyOf(const IgtlMessage& message)
{
    std::vector<std::byte> body;
    IgtlWriter out{body};
    const bool isBare = std::holds_alternative<IgtlQuery>(message.content);
    if (message.version < 2 || (isBare && message.metadata.empty())) {
        writeContent(out, message.content);
        return body;
    }
    std::size_t words = 0;
    for (const IgtlMetadata& entry : message.metadata)
        words += entry.key.size() + entry.value.size();
    out.number(kExtensionBytes);
    out.number(static_cast<std::uint16_t>(2 + kMetadataEntryBytes * message.metadata.size()));
    out.number(static_cast<std::uint32_t>(words));
    out.number(message.id);
    writeContent(out, message.content);
    writeMetadata(out, message.metadata);
    return body;
}

/// Names the type of the content that it is called with.
struct TypeNamer {
    std::string operator()(const IgtlTransform&) const { return "TRANSFORM"; }
    std::string operator()(const IgtlPosition&) const { return "POSITION"; }
    std::string operator()(const IgtlTrackingData&) const { return "TDATA"; }
    std::string operator()(const IgtlQuaternionTrackingData&) const { return "QTDATA"; }
    std::string operator()(const IgtlStart& start) const
    {
        return start.asksQuaternions ? "STT_QTDATA" : "STT_TDATA";
    }
    std::string operator()(const IgtlStatus&) const { return "STATUS"; }
    std::string operator()(const IgtlString&) const { return "STRING"; }
    std::string operator()(const IgtlPoints&) const { return "POINT"; }
    std::string operator()(const IgtlPolyData&) const { return "POLYDATA"; }
    std::string operator()(const IgtlQuery& query) const { return query.type; }
    std::string operator()(const IgtlReply& reply) const { return reply.type; }
    std::string operator()(const IgtlSkipped& skipped) const { return skipped.type; }
};

} // namespace

Result<IgtlHeader> IgtlHeader::read(std::span<const std::byte> bytes)
{
    IgtlBytes in{bytes};
    IgtlHeader header;
    header.version = in.number<std::uint16_t>();
    header.type = in.field(kTypeName);
    header.device = in.field(kDeviceName);
    header.stamp = in.number<std::uint64_t>();
    header.bodyBytes = in.number<std::uint64_t>();
    header.checksum = in.number<std::uint64_t>();
    CARINA_EXPECTS(in.ok());
    const bool isText = !header.type.empty() && std::ranges::all_of(header.type, [](char c) {
        return c > ' ' && c <= '~';
    });
    if (header.version < 1 || header.version > 2 || !isText)
        return fail(Errc::DeviceReplyDamaged, "no header of OpenIGTLink");
    if (header.bodyBytes > kLongestIgtlBody)
        return damaged(header.type, "size of the body");
    return header;
}

bool isReadIgtlType(const std::string& type)
{
    return type.starts_with("GET_") || type.starts_with("STP_")
           || std::ranges::find(kReadTypes, type) != kReadTypes.end();
}

std::string typeOf(const IgtlContent& content) { return std::visit(TypeNamer{}, content); }

Result<IgtlMessage> decodeIgtl(const IgtlHeader& header, std::span<const std::byte> body)
{
    CARINA_EXPECTS(body.size() == header.bodyBytes);
    if (igtlChecksum(body) != header.checksum)
        return damaged(header.type, "checksum");
    IgtlMessage message{header.version, header.device, header.stamp, 0, {}, IgtlQuery{header.type}};
    IgtlBytes bytes{body};
    // A query may come without an extension, as a message that every server can pass over.
    const bool isExtended = header.version == 2 && !body.empty();
    IgtlBytes content = isExtended ? readExtended(bytes, message) : bytes;
    if (isExtended && !bytes.ok())
        return damaged(header.type, bytes.brokenRule());
    if (header.type == "POLYDATA")
        message.content = readPolyData(content);
    else
        message.content = readSmallContent(header.type, content);
    content.require(content.remaining() == 0, "size of the body");
    if (!content.ok())
        return damaged(header.type, content.brokenRule());
    return message;
}

std::vector<std::byte> encodeIgtl(const IgtlMessage& message)
{
    const std::vector<std::byte> body = bodyOf(message);
    std::vector<std::byte> bytes;
    bytes.reserve(IgtlHeader::kBytes + body.size());
    IgtlWriter out{bytes};
    out.number(message.version);
    out.field(typeOf(message.content), kTypeName);
    out.field(message.device, kDeviceName);
    out.number(message.stamp);
    out.number(std::uint64_t{body.size()});
    out.number(igtlChecksum(body));
    bytes.insert(bytes.end(), body.begin(), body.end());
    return bytes;
}

} // namespace carina
