#include "engine/net/secure/dtls.h"

#include "engine/core/monotonic_clock.h"
#include "engine/net/secure/endpoint.h"

#include <QSslCipher>
#include <QSslConfiguration>
#include <QSslPreSharedKeyAuthenticator>

#include <array>

namespace carina
{
namespace
{

constexpr quint16 kMtu = 1200;
/// Failures to read after which the next datagrams wait for the next turn.
constexpr int kMostFaults = 8;
constexpr const char* kCertificateCiphers =
    "ECDHE-ECDSA-CHACHA20-POLY1305:ECDHE-RSA-CHACHA20-POLY1305";

QSslConfiguration configurationOf(const char* ciphers)
{
    QSslConfiguration configuration = QSslConfiguration::defaultDtlsConfiguration();
    configuration.setProtocol(QSsl::DtlsV1_2);
    configuration.setCiphers(QLatin1String{ciphers});
    configuration.setPeerVerifyMode(QSslSocket::VerifyNone); // unless a certificate is expected
    return configuration;
}

void use(const QSslConfiguration& configuration, QDtls& dtls)
{
    dtls.setDtlsConfiguration(configuration);
    dtls.setMtuHint(kMtu);
}

} // namespace

void prepareDtls(QDtls& dtls, const QByteArray& hint)
{
    QSslConfiguration configuration = configurationOf("ECDHE-PSK-CHACHA20-POLY1305");
    configuration.setPreSharedKeyIdentityHint(hint);
    use(configuration, dtls);
}

void prepareDtls(QDtls& dtls, const HostCertificate& certificate)
{
    QSslConfiguration configuration = configurationOf(kCertificateCiphers);
    configuration.setLocalCertificateChain(certificate.chain);
    configuration.setPrivateKey(certificate.key);
    use(configuration, dtls);
}

void prepareDtls(QDtls& dtls, const ExpectedCertificate& expected)
{
    QSslConfiguration configuration = configurationOf(kCertificateCiphers);
    configuration.setPeerVerifyMode(QSslSocket::VerifyPeer);
    configuration.setCaCertificates(expected.authorities);
    use(configuration, dtls);
}

void answerPsk(QSslPreSharedKeyAuthenticator& question, const std::string& identity,
               const AccessKey& key)
{
    if (!identity.empty())
        question.setIdentity(QByteArray::fromStdString(identity));
    question.setPreSharedKey(
        QByteArray{viewOf(key).constData(), static_cast<qsizetype>(key.size())});
}

std::optional<RawDatagram> readRaw(QUdpSocket& socket)
{
    // Reads even where nothing is there: a QUdpSocket that told of a datagram tells of no other
    // before it was read from, and the datagram may have been taken already.
    for (int faults = 0; faults < kMostFaults;) {
        RawDatagram datagram;
        std::array<char, kLongestRaw + 1> buffer;
        const qint64 size = socket.readDatagram(buffer.data(), qint64(buffer.size()),
                                                &datagram.from, &datagram.port);
        if (size < 0 && socket.error() == QAbstractSocket::TemporaryError)
            return std::nullopt; // nothing more is there
        if (size < 0)
            ++faults; // such as a port of a peer that nobody listens at
        if (!isSizeOfRaw(size))
            continue;
        datagram.bytes = QByteArray{buffer.data(), size}; // no longer: thousands may wait
        datagram.from = normalised(datagram.from);
        datagram.arrived = monotonicNow();
        return datagram;
    }
    return std::nullopt;
}

std::span<const std::uint8_t> octets(const QByteArray& bytes)
{
    return {reinterpret_cast<const std::uint8_t*>(bytes.data()),
            static_cast<std::size_t>(bytes.size())};
}

QByteArray viewOf(std::span<const std::byte> bytes)
{
    return QByteArray::fromRawData(reinterpret_cast<const char*>(bytes.data()),
                                   static_cast<qsizetype>(bytes.size()));
}

} // namespace carina
