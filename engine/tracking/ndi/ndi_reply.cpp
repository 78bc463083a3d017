#include "engine/tracking/ndi/ndi_reply.h"

#include "engine/core/byte_buffer.h"
#include "engine/tracking/ndi/ndi_error.h"

#include <charconv>
#include <utility>

namespace carina
{
namespace
{

constexpr std::size_t kChecksumDigits = 4;
constexpr std::size_t kChecksumBytes = 2;
// The first two bytes of a binary reply, as they are sent: 0xA5C4 with a length of 16 bits, 0xA5C8
// with one of 32.
constexpr std::string_view kBinary = "\xC4\xA5";
constexpr std::string_view kLongBinary = "\xC8\xA5";

tl::unexpected<Error> damaged(const char* what) { return fail(Errc::DeviceReplyDamaged, what); }

std::span<const std::byte> bytesOf(std::string_view text) { return std::as_bytes(std::span{text}); }

std::uint16_t checksumAt(std::string_view bytes, std::size_t at)
{
    return ByteReader{bytesOf(bytes.substr(at))}.number<std::uint16_t>();
}

} // namespace

Result<std::string_view> checkedText(std::string_view text)
{
    if (text.size() < kChecksumDigits)
        return damaged("shorter than a checksum");
    const std::string_view content = text.substr(0, text.size() - kChecksumDigits);
    if (text.substr(content.size()) != ndiChecksumText(content))
        return damaged("wrong checksum");
    return content;
}

std::optional<std::uint8_t> errorCode(const NdiReply& reply)
{
    constexpr std::string_view kError = "ERROR";
    if (reply.form != NdiReply::Form::Text || !reply.bytes.starts_with(kError)
        || reply.bytes.size() != kError.size() + 2)
        return std::nullopt;
    const char* const digits = reply.bytes.data() + kError.size();
    std::uint8_t code = 0;
    const auto [end, fault] = std::from_chars(digits, digits + 2, code, 16);
    return fault == std::errc{} && end == digits + 2 ? std::optional{code} : std::nullopt;
}

bool isFine(const NdiReply& reply)
{
    return reply.bytes == "OKAY" || reply.bytes.starts_with("WARNING");
}

std::string whyRefused(const NdiReply& reply)
{
    const auto code = errorCode(reply);
    return code ? errorMeaning(*code) : "an answer that is not expected";
}

void NdiReplyReader::take(std::span<const std::byte> arrived)
{
    if (m_bytes.size() + arrived.size() > kLongestNdiReply + kChecksumBytes) {
        m_bytes.clear();
        m_overflowed = true;
        return;
    }
    m_bytes.append(reinterpret_cast<const char*>(arrived.data()), arrived.size());
}

std::optional<Result<NdiReply>> NdiReplyReader::next()
{
    if (std::exchange(m_overflowed, false))
        return damaged("longer than any reply");
    // The first byte alone does not tell: 0xC4 begins no text.
    const std::string_view begin = std::string_view{m_bytes}.substr(0, kBinary.size());
    if (begin == kBinary)
        return nextBinary(sizeof(std::uint16_t));
    if (begin == kLongBinary)
        return nextBinary(sizeof(std::uint32_t));
    if (begin.size() == 1 && (begin[0] == kBinary[0] || begin[0] == kLongBinary[0]))
        return std::nullopt;
    return nextText();
}

std::optional<Result<NdiReply>> NdiReplyReader::nextText()
{
    const std::size_t end = m_bytes.find('\r');
    if (end == std::string::npos)
        return std::nullopt;
    std::string text = taken(end + 1);
    text.pop_back();
    return checkedText(text).map([](std::string_view content) {
        return NdiReply{NdiReply::Form::Text, std::string{content}};
    });
}

std::optional<Result<NdiReply>> NdiReplyReader::nextBinary(std::size_t lengthBytes)
{
    const std::size_t headerBytes = kBinary.size() + lengthBytes + kChecksumBytes;
    if (m_bytes.size() < headerBytes)
        return std::nullopt;
    const std::size_t checkedBytes = headerBytes - kChecksumBytes;
    if (ndiChecksum(std::string_view{m_bytes}.substr(0, checkedBytes))
        != checksumAt(m_bytes, checkedBytes)) {
        // Its length cannot be trusted: reading goes on behind the two bytes that began it.
        static_cast<void>(taken(kBinary.size()));
        return damaged("wrong checksum of a header");
    }
    ByteReader header{bytesOf(m_bytes).subspan(kBinary.size())};
    const std::size_t length = lengthBytes == sizeof(std::uint16_t)
                                   ? header.number<std::uint16_t>()
                                   : header.number<std::uint32_t>();
    if (length > kLongestNdiReply - headerBytes) {
        static_cast<void>(taken(headerBytes));
        return damaged("longer than any reply");
    }
    if (m_bytes.size() < headerBytes + length + kChecksumBytes)
        return std::nullopt;
    const std::string whole = taken(headerBytes + length + kChecksumBytes);
    std::string body = whole.substr(headerBytes, length);
    if (ndiChecksum(body) != checksumAt(whole, headerBytes + length))
        return damaged("wrong checksum");
    return NdiReply{NdiReply::Form::Binary, std::move(body)};
}

std::string NdiReplyReader::taken(std::size_t count)
{
    std::string first = m_bytes.substr(0, count);
    m_bytes.erase(0, count);
    return first;
}

} // namespace carina
