#include "engine/net/devices/device_log.h"

#include "engine/core/monotonic_clock.h"
#include "engine/net/devices/device_log_header.h"

#include <QJsonDocument>

#include <array>
#include <cstdio>

namespace carina
{
namespace
{

/// Of which only what prints is left as it is. A space at the end would be lost: readers trim.
std::string escaped(std::string_view bytes)
{
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const char c = bytes[i];
        const bool isLast = i + 1 == bytes.size();
        const auto byte = static_cast<unsigned char>(c);
        if (c == '\\')
            text += "\\\\";
        else if (byte >= 0x20 && byte < 0x7F && !(c == ' ' && isLast))
            text += c;
        else
            text += {'\\', 'x', kDigits[byte >> 4U], kDigits[byte & 0xFU]};
    }
    return text;
}

} // namespace

DeviceLog::DeviceLog(const std::filesystem::path& file)
    : m_file{QString::fromStdString(file.string())},
      m_since1970{std::chrono::system_clock::now().time_since_epoch()
                  - monotonicNow().time_since_epoch()}
{
}

Result<std::unique_ptr<DeviceLog>> DeviceLog::create(const std::filesystem::path& file,
                                                     const TrackerDescription& description)
{
    std::unique_ptr<DeviceLog> log{new DeviceLog{file}};
    if (!log->m_file.open(QIODevice::WriteOnly | QIODevice::Truncate | QIODevice::Unbuffered))
        return fail(Errc::FileUnwritable, file.string());
    log->write(
        std::string{kDeviceLogBegins}
        + QJsonDocument{deviceLogHeader(description)}.toJson(QJsonDocument::Compact).toStdString()
        + '\n');
    if (log->hasFailed())
        return fail(Errc::FileUnwritable, file.string());
    return log;
}

std::string DeviceLog::stamp(LocalTime now) const
{
    const auto since1970 = (now.time_since_epoch() + m_since1970).count();
    std::array<char, 64> text{};
    const int length = std::snprintf(text.data(), text.size(), "%lld.%09lld : (INFO) ",
                                     static_cast<long long>(since1970 / 1'000'000'000),
                                     static_cast<long long>(since1970 % 1'000'000'000));
    return {text.data(), static_cast<std::size_t>(length)};
}

void DeviceLog::opened(LocalTime now) { write(stamp(now) + kDeviceLogOpened + '\n'); }

void DeviceLog::exchanged(std::string_view received, std::string_view sent, LocalTime now)
{
    std::string lines;
    const auto add = [&](const char* word, std::string_view bytes) {
        lines += stamp(now) + std::to_string(m_commands) + ". " + word + '['
                 + std::to_string(bytes.size()) + "] " + escaped(bytes) + '\n';
    };
    if (!received.empty())
        add("receive", received);
    if (!sent.empty()) {
        ++m_commands;
        add("command", sent);
    }
    if (lines.empty())
        lines = stamp(now) + kDeviceLogWaited + '\n';
    write(lines);
}

void DeviceLog::write(const std::string& lines)
{
    if (m_hasFailed)
        return;
    m_hasFailed = m_file.write(lines.data(), qint64(lines.size())) != qint64(lines.size());
}

} // namespace carina
