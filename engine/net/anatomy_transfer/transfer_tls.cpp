#include "engine/net/anatomy_transfer/transfer_tls.h"

#include <QSslSocket>

namespace carina::transfer
{

QSslConfiguration tlsConfiguration(const QByteArray& hint)
{
    QSslConfiguration configuration;
    configuration.setProtocol(QSsl::TlsV1_2);
    configuration.setCiphers(QStringLiteral("ECDHE-PSK-CHACHA20-POLY1305"));
    configuration.setPeerVerifyMode(QSslSocket::VerifyNone); // the key proves it, no certificate
    configuration.setPreSharedKeyIdentityHint(hint);
    configuration.setSslOption(QSsl::SslOptionDisableSessionTickets, true);
    return configuration;
}

} // namespace carina::transfer
