#include "engine/net/secure/hello_cookies.h"

#include "engine/net/secure/dtls_record.h"

namespace carina
{
namespace
{

std::unique_ptr<QDtlsClientVerifier> verifierWithNewSecret()
{
    auto verifier = std::make_unique<QDtlsClientVerifier>();
    const AccessKey secret = randomKey();
    verifier->setCookieGeneratorParameters(
        {QCryptographicHash::Sha256,
         QByteArray{viewOf(secret).constData(), static_cast<qsizetype>(secret.size())}});
    return verifier;
}

} // namespace

/// Sends nothing: a QDtlsClientVerifier that is only asked would answer with a cookie, too. To a
/// connected socket it writes as to any device.
class HelloCookies::SilentSocket : public QUdpSocket
{
public:
    SilentSocket()
    {
        setOpenMode(QIODevice::ReadWrite);
        setSocketState(ConnectedState);
    }
    ~SilentSocket() override { setSocketState(UnconnectedState); }
    SilentSocket(const SilentSocket&) = delete;
    SilentSocket& operator=(const SilentSocket&) = delete;

protected:
    qint64 writeData(const char* /*data*/, qint64 length) override { return length; }
};

HelloCookies::HelloCookies() : m_silent{std::make_unique<SilentSocket>()} {}

HelloCookies::~HelloCookies() = default;

std::optional<QDtls::GeneratorParameters>
HelloCookies::check(QUdpSocket& socket, const RawDatagram& hello, LocalTime now)
{
    renew(now);
    if (holdsCookie(octets(hello.bytes)))
        for (QDtlsClientVerifier* verifier : {m_verifier.get(), m_former.get()})
            if (verifier
                && verifier->verifyClient(m_silent.get(), hello.bytes, hello.from, hello.port))
                return verifier->cookieGeneratorParameters();
    m_verifier->verifyClient(&socket, hello.bytes, hello.from, hello.port);
    return std::nullopt;
}

void HelloCookies::renew(LocalTime now)
{
    if (now < m_nextSecret)
        return;
    const bool isFormerValid = m_verifier && now < m_nextSecret + kPeriod;
    m_former = isFormerValid ? std::move(m_verifier) : nullptr;
    m_verifier = verifierWithNewSecret();
    m_nextSecret = now + kPeriod;
}

} // namespace carina
