#pragma once

#include "tests/engine/net/entry/made_certificates.h"
#include "tests/engine/net/secure/transports.h"

namespace carina
{

/// A host that proves itself.
struct CertifiedHost : TestHost {
    explicit CertifiedHost(HostCertificate certificate, std::uint16_t port = 0) : TestHost{port}
    {
        transport->present(std::move(certificate));
    }
};

inline HostCertificate readCertificate(const MadeCertificates& made, const char* name)
{
    return *HostCertificate::read(made.certificate(name), made.key(name));
}

/// Also one that is over: an attacker presents it all the same.
inline HostCertificate uncheckedCertificate(const MadeCertificates& made, const char* name)
{
    QFile certificate{made.path(QLatin1String{name}, "pem")};
    QFile key{made.path(QLatin1String{name}, "key")};
    if (!certificate.open(QIODevice::ReadOnly) || !key.open(QIODevice::ReadOnly))
        return {};
    return {QSslCertificate::fromData(certificate.readAll()), QSslKey{key.readAll(), QSsl::Ec},
            "carina.example"};
}

/// For a client that wants a certificate from our authority for this name.
inline ExpectedCertificate expectedFrom(const MadeCertificates& made,
                                        const char* name = "carina.example")
{
    return *ExpectedCertificate::read(name, made.certificate("ours"));
}

} // namespace carina
