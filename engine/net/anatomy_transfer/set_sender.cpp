#include "engine/net/anatomy_transfer/set_sender.h"

#include "engine/core/monotonic_clock.h"
#include "engine/net/anatomy_transfer/set_listener.h"
#include "engine/net/secure/dtls.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

/// The longest frame of a client.
constexpr qint64 kLongestQuestion = 1024;
/// Of one transfer, not yet handed to the system.
constexpr qint64 kMostWaiting = qint64{64} << 10U;
/// Of one transfer, handed to the system and not acknowledged: what a slow link may have in its
/// queue before a pose.
constexpr int kMostUnderWay = 64 << 10;
constexpr std::size_t kChunk = std::size_t{16} << 10U; ///< one record of TLS

} // namespace

SetSender::SetSender(QSslSocket& socket, SetListener& listener, const SetPatience& patience)
    : QObject{&socket},
      m_socket{socket},
      m_listener{listener},
      m_leastBytes{patience.leastBytes},
      m_began{monotonicNow()},
      m_measuredFrom{m_began},
      m_windowBegan{m_began}
{
    socket.setReadBufferSize(kLongestQuestion);
    socket.setSocketOption(QAbstractSocket::SendBufferSizeSocketOption, kMostUnderWay);
    connect(&socket, &QSslSocket::encryptedBytesWritten, this,
            [this](qint64 bytes) { m_moved += static_cast<std::uint64_t>(bytes); });
    m_window.setInterval(std::chrono::duration_cast<std::chrono::milliseconds>(patience.window));
    m_window.callOnTimeout(this, &SetSender::endWindow);
    m_window.start();
}

void SetSender::start()
{
    connect(&m_socket, &QSslSocket::readyRead, this, &SetSender::read);
    read(); // what came with the handshake
}

void SetSender::endWindow()
{
    if (m_moved < m_leastBytes)
        return m_socket.abort();
    m_measuredFrom = m_windowBegan;
    m_windowBegan = monotonicNow();
    m_movedBefore = std::exchange(m_moved, 0);
}

double SetSender::bytesPerSecond(LocalTime now) const
{
    constexpr Duration kLeast = std::chrono::seconds{1}; // so that what has just come is not fast
    return static_cast<double>(m_movedBefore + m_moved)
           / toSeconds(std::max(now - m_measuredFrom, kLeast));
}

void SetSender::read()
{
    m_received += m_socket.read(kLongestQuestion - m_received.size());
    auto bytes = std::as_bytes(octets(m_received));
    while (m_socket.state() == QAbstractSocket::ConnectedState) {
        const auto frame = transfer::takeFrame(bytes);
        if (!frame)
            return m_socket.abort();
        if (!*frame)
            break;
        take(**frame);
    }
    m_received = m_received.last(static_cast<qsizetype>(bytes.size()));
    if (m_received.size() == kLongestQuestion)
        m_socket.abort();
}

void SetSender::take(const transfer::Frame& frame)
{
    if (const auto* want = std::get_if<transfer::Want>(&frame); want && !m_file.isOpen())
        offer(*want);
    else if (const auto* get = std::get_if<transfer::Get>(&frame); get && m_left == 0)
        begin(get->offset);
    else
        m_socket.abort();
}

void SetSender::offer(const transfer::Want& want)
{
    if (want.version != transfer::kVersion)
        return refuse(transfer::Reason::OtherVersion);
    const auto set = m_listener.find(want.contentHash);
    if (!set)
        return refuse(set.error());
    m_file.setFileName(QString::fromStdString(m_listener.fileOf(*set).string()));
    if (!m_file.open(QIODevice::ReadOnly))
        return refuse(transfer::Reason::Withdrawn);
    write(transfer::Offer{set->bytes, set->digest, set->licence});
}

void SetSender::begin(std::uint64_t offset)
{
    const auto size = static_cast<std::uint64_t>(m_file.size());
    if (!m_file.isOpen() || offset >= size || !m_file.seek(static_cast<qint64>(offset)))
        return m_socket.abort();
    m_left = size - offset;
    m_listener.giveTurns(*this);
}

bool SetSender::sendChunk()
{
    if (m_socket.bytesToWrite() + m_socket.encryptedBytesToWrite() > kMostWaiting)
        return false;
    const QByteArray chunk =
        m_file.read(static_cast<qint64>(std::min<std::uint64_t>(kChunk, m_left)));
    if (chunk.isEmpty()) {
        refuse(transfer::Reason::Withdrawn);
        return true;
    }
    m_left -= static_cast<std::uint64_t>(chunk.size());
    write(transfer::Chunk{std::as_bytes(octets(chunk))});
    return true;
}

void SetSender::refuse(transfer::Reason reason)
{
    m_left = 0;
    write(transfer::Refusal{reason});
    m_socket.disconnectFromHost();
}

void SetSender::write(const transfer::Frame& frame)
{
    const auto bytes = transfer::encode(frame);
    m_socket.write(viewOf(bytes).constData(), static_cast<qint64>(bytes.size()));
}

} // namespace carina
