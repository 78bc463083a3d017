#include "engine/net/anatomy_transfer/set_sender.h"

#include "engine/net/anatomy_transfer/set_listener.h"
#include "engine/net/secure/dtls.h"

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

SetSender::SetSender(QSslSocket& socket, SetListener& listener)
    : QObject{&socket}, m_socket{socket}, m_listener{listener}
{
    socket.setReadBufferSize(kLongestQuestion);
    socket.setSocketOption(QAbstractSocket::SendBufferSizeSocketOption, kMostUnderWay);
    connect(&socket, &QSslSocket::readyRead, this, &SetSender::read);
    connect(&socket, &QSslSocket::encryptedBytesWritten, &m_patience,
            [this] { m_patience.start(); });
    m_patience.setSingleShot(true);
    m_patience.setInterval(
        std::chrono::duration_cast<std::chrono::milliseconds>(SetServer::kPatience));
    m_patience.callOnTimeout(&socket, &QSslSocket::abort);
    m_patience.start();
    read(); // what came with the handshake
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
