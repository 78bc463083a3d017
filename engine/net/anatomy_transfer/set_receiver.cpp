#include "engine/net/anatomy_transfer/set_receiver.h"

#include "engine/net/anatomy_transfer/transfer_tls.h"
#include "engine/net/secure/dtls.h"

#include <QNetworkProxy>
#include <QSslPreSharedKeyAuthenticator>

#include <algorithm>

namespace carina
{
namespace
{

/// Bytes buffered here while the disk is written; flow control holds the rest at the host.
constexpr qint64 kMostUnread = qint64{256} << 10U;
constexpr auto kLongestFrame = static_cast<qsizetype>(transfer::kHeaderBytes + transfer::kMostBody);

std::chrono::milliseconds inMilliseconds(Duration d)
{
    return std::chrono::duration_cast<std::chrono::milliseconds>(d);
}

std::string mebibytes(std::uint64_t bytes) { return std::to_string(bytes >> 20U) + " MiB"; }

} // namespace

SetReceiver::SetReceiver(SetFetch& fetch, HostDoor door, std::string contentHash,
                         std::filesystem::path cacheFolder)
    : m_fetch{fetch},
      m_door{std::move(door)},
      m_contentHash{std::move(contentHash)},
      m_sets{std::move(cacheFolder)}
{
    m_again.setSingleShot(true);
    m_again.callOnTimeout(this, &SetReceiver::connectToHost);
    m_patience.setSingleShot(true);
    m_patience.setInterval(inMilliseconds(SetFetch::kPatience));
    m_patience.callOnTimeout(this, &SetReceiver::broken);
}

void SetReceiver::DeleteLater::operator()(QSslSocket* socket) const
{
    socket->disconnect();
    socket->abort();
    socket->deleteLater(); // it may be telling us something
}

void SetReceiver::connectToHost()
{
    makeSocket();
    m_received.clear();
    m_patience.start();
    m_socket->connectToHostEncrypted(QString::fromStdString(m_door.address), m_door.port);
}

void SetReceiver::makeSocket()
{
    m_socket.reset(new QSslSocket);
    m_socket->setProxy(QNetworkProxy::NoProxy);
    m_socket->setSslConfiguration(transfer::tlsConfiguration({}));
    m_socket->setReadBufferSize(kMostUnread);
    connect(m_socket.get(), &QSslSocket::preSharedKeyAuthenticationRequired, this,
            [this](QSslPreSharedKeyAuthenticator* question) { answerKey(*question); });
    connect(m_socket.get(), &QSslSocket::encrypted, this, &SetReceiver::ask);
    connect(m_socket.get(), &QSslSocket::readyRead, this, &SetReceiver::read);
    connect(m_socket.get(), &QSslSocket::errorOccurred, this, &SetReceiver::broken);
}

void SetReceiver::answerKey(QSslPreSharedKeyAuthenticator& question) const
{
    // Another session's host at this address gets nothing to try our key on.
    if (question.identityHint().toStdString() == m_door.offer.identity.sessionId)
        answerPsk(question, toText(m_door.offer.identity), m_door.offer.key);
}

void SetReceiver::ask()
{
    m_rejections = 0;
    const auto bytes = transfer::encode(transfer::Want{transfer::kVersion, m_contentHash});
    m_socket->write(viewOf(bytes).constData(), static_cast<qint64>(bytes.size()));
}

void SetReceiver::broken()
{
    read(); // a refusal may lie there
    if (!m_socket)
        return;
    const auto error = m_socket->error();
    const bool rejected = error == QAbstractSocket::SslHandshakeFailedError
                          || error == QAbstractSocket::SslInternalError
                          || error == QAbstractSocket::SslInvalidUserDataError;
    if (rejected && ++m_rejections >= SetFetch::kRejectionsBelieved)
        return giveUp({Errc::WrongCode, {}});
    retry(Error{Errc::HostSilent, "TCP " + std::to_string(m_door.port)});
}

void SetReceiver::read()
{
    while (m_socket && m_socket->bytesAvailable() > 0) {
        m_patience.start();
        m_received += m_socket->read(kLongestFrame - m_received.size());
        auto bytes = std::as_bytes(octets(m_received));
        while (m_socket) {
            const auto frame = transfer::takeFrame(bytes);
            if (!frame)
                return giveUp(frame.error());
            if (!*frame)
                break;
            take(**frame);
        }
        m_received = m_received.last(static_cast<qsizetype>(bytes.size()));
    }
}

void SetReceiver::take(const transfer::Frame& frame)
{
    if (const auto* offer = std::get_if<transfer::Offer>(&frame))
        take(*offer);
    else if (const auto* refusal = std::get_if<transfer::Refusal>(&frame))
        take(*refusal);
    else if (const auto* chunk = std::get_if<transfer::Chunk>(&frame))
        take(*chunk);
    else
        giveUp({Errc::PacketMalformed, "a host does not ask for sets"});
}

void SetReceiver::take(const transfer::Offer& offer)
{
    if (m_partial)
        return giveUp({Errc::PacketMalformed, "one offer only"});
    m_status.set = {offer.digest, offer.bytes, offer.licence};
    if (offer.bytes == 0 || offer.bytes > CarriedSets::kMostBytes)
        return giveUp({Errc::OutOfRange, "a set of " + mebibytes(offer.bytes) + "; at most "
                                             + mebibytes(CarriedSets::kMostBytes)});
    if (m_sets.has(m_status.set))
        return arrived();
    auto partial = m_sets.resume(m_status.set);
    if (!partial)
        return giveUp(partial.error());
    if (!*partial) // another program fetches it; it will be here soon
        return retry(std::nullopt);
    m_partial = *std::move(partial);
    m_resumed = m_partial->bytes() > 0;
    m_status.state = FetchStatus::State::Receiving;
    m_status.received = m_partial->bytes();
    m_status.fault.reset();
    show();
    if (m_partial->bytes() == offer.bytes)
        return finish();
    const auto bytes = transfer::encode(transfer::Get{m_partial->bytes()});
    m_socket->write(viewOf(bytes).constData(), static_cast<qint64>(bytes.size()));
}

void SetReceiver::take(const transfer::Refusal& refusal)
{
    switch (refusal.reason) {
    case transfer::Reason::NotNamed:
        return giveUp({Errc::SetNotNamed, {}});
    case transfer::Reason::Withdrawn:
        return giveUp({Errc::SetWithdrawn, {}});
    case transfer::Reason::OtherVersion:
        return giveUp({Errc::VersionMismatch, {}});
    case transfer::Reason::Busy:
        retry(std::nullopt);
    }
}

void SetReceiver::take(const transfer::Chunk& chunk)
{
    if (!m_partial || chunk.bytes.size() > m_status.set.bytes - m_partial->bytes())
        return giveUp({Errc::PacketMalformed, "more than was offered"});
    if (const auto kept = m_partial->append(chunk.bytes); !kept)
        return giveUp(kept.error());
    m_pause = SetFetch::kFirstPause;
    m_status.received = m_partial->bytes();
    show();
    if (m_status.received == m_status.set.bytes)
        finish();
}

void SetReceiver::finish()
{
    const auto finished = m_partial->finish();
    if (finished)
        return arrived();
    // What an earlier run left may have been damaged meanwhile: once more, from the first byte on.
    if (finished.error().code == Errc::FileMalformed && m_resumed)
        return retry(std::nullopt);
    giveUp(finished.error());
}

void SetReceiver::arrived()
{
    m_status.state = FetchStatus::State::Here;
    m_status.received = m_status.set.bytes;
    m_status.fault.reset();
    m_patience.stop();
    m_partial.reset();
    m_socket.reset();
    show();
}

void SetReceiver::retry(std::optional<Error> fault)
{
    m_status.state = FetchStatus::State::Asking;
    m_status.fault = std::move(fault);
    m_patience.stop();
    m_partial.reset();
    m_socket.reset();
    m_again.start(inMilliseconds(m_pause));
    m_pause = std::min(2 * m_pause, SetFetch::kLongestPause);
    show();
}

void SetReceiver::giveUp(Error why)
{
    m_status.state = FetchStatus::State::Failed;
    m_status.fault = std::move(why);
    m_patience.stop();
    m_partial.reset();
    m_socket.reset();
    show();
}

} // namespace carina
