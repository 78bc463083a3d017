#include "engine/net/entry/certificates.h"

#include "engine/io/files/whole_file.h"
#include "engine/net/discovery/addresses.h"
#include "engine/net/secure/dtls.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QSslConfiguration>

#include <algorithm>

namespace carina
{
namespace
{

/// Host name that guests are to expect in a wildcard certificate, in place of the asterisk.
const QString kAnyHost = QStringLiteral("carina");

Result<QByteArray> pemIn(const std::filesystem::path& file)
{
    return readWholeFile(file, kCredentialLimit).map([](const std::string& text) {
        return QByteArray::fromStdString(text);
    });
}

Result<QList<QSslCertificate>> certificatesIn(const std::filesystem::path& file)
{
    const auto pem = pemIn(file);
    if (!pem)
        return tl::unexpected(pem.error());
    const auto found = QSslCertificate::fromData(*pem, QSsl::Pem);
    if (found.isEmpty())
        return fail(Errc::FileMalformed, file.string() + ": it holds no certificate in PEM");
    return found;
}

Result<QSslKey> keyIn(const std::filesystem::path& file)
{
    const auto pem = pemIn(file);
    if (!pem)
        return tl::unexpected(pem.error());
    for (const QSsl::KeyAlgorithm algorithm : {QSsl::Ec, QSsl::Rsa})
        if (QSslKey key{*pem, algorithm, QSsl::Pem}; !key.isNull())
            return key;
    return fail(Errc::FileMalformed,
                file.string() + ": it holds no private key in PEM without a password");
}

/// The first that a certificate is for; empty for none.
std::string nameIn(const QSslCertificate& certificate)
{
    const auto others = certificate.subjectAlternativeNames();
    for (QString name : others.values(QSsl::DnsEntry) + others.values(QSsl::IpAddressEntry)
                            + certificate.subjectInfo(QSslCertificate::CommonName)) {
        name.replace(QLatin1Char{'*'}, kAnyHost);
        if (isHostName(name.toStdString()))
            return name.toStdString();
    }
    return {};
}

/// OpenSSL sees for itself whether a key fits, before it looks at the first datagram.
bool belongTogether(const HostCertificate& certificate)
{
    QUdpSocket socket;
    QDtls dtls{QSslSocket::SslServerMode};
    dtls.setPeer(QHostAddress{QHostAddress::LocalHost}, 1);
    prepareDtls(dtls, certificate);
    static_cast<void>(dtls.doHandshake(&socket, "no hello"));
    return dtls.dtlsError() != QDtlsError::TlsInitializationError;
}

bool isAboutTime(const QSslError& error)
{
    return error.error() == QSslError::CertificateExpired
           || error.error() == QSslError::CertificateNotYetValid;
}

bool isAboutName(const QSslError& error) { return error.error() == QSslError::HostNameMismatch; }

} // namespace

Result<HostCertificate> HostCertificate::read(const std::filesystem::path& certificate,
                                              const std::filesystem::path& privateKey)
{
    const auto chain = certificatesIn(certificate);
    if (!chain)
        return tl::unexpected(chain.error());
    const auto key = keyIn(privateKey);
    if (!key)
        return tl::unexpected(key.error());
    const QSslCertificate& own = chain->first();
    HostCertificate read{*chain, *key, nameIn(own)};
    if (read.name.empty())
        return fail(Errc::FileMalformed, certificate.string() + ": it is for no host");
    const QDateTime now = QDateTime::currentDateTimeUtc();
    if (now < own.effectiveDate() || now > own.expiryDate())
        return fail(Errc::CertificateExpired, certificate.string());
    if (!belongTogether(read))
        return fail(Errc::KeyDoesNotFit, privateKey.string());
    return read;
}

Result<ExpectedCertificate> ExpectedCertificate::read(const std::string& name,
                                                      const std::filesystem::path& authorities)
{
    const QString expected = QString::fromStdString(name);
    if (authorities.empty())
        return ExpectedCertificate{expected, QSslConfiguration::systemCaCertificates()};
    return certificatesIn(authorities).map([&](const QList<QSslCertificate>& trusted) {
        return ExpectedCertificate{expected, trusted};
    });
}

CertificateDigest digestOf(const QSslCertificate& certificate)
{
    const QByteArray digest = certificate.digest(QCryptographicHash::Sha256);
    CertificateDigest bytes{};
    std::ranges::copy(std::as_bytes(octets(digest)).first(bytes.size()), bytes.begin());
    return bytes;
}

Error certificateFault(const QList<QSslError>& errors, const QString& expectedName)
{
    const auto grave = std::ranges::find_if(
        errors, [](const QSslError& e) { return !isAboutTime(e) && !isAboutName(e); });
    if (grave != errors.end() || errors.isEmpty())
        return {Errc::CertificateUntrusted,
                errors.isEmpty() ? std::string{} : grave->errorString().toStdString()};
    if (std::ranges::any_of(errors, isAboutTime))
        return {Errc::CertificateExpired, expectedName.toStdString()};
    return {Errc::CertificateOfAnother, "not " + expectedName.toStdString()};
}

} // namespace carina
