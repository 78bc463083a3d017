#pragma once

#include "engine/core/result.h"
#include "engine/net/entry/role_proof.h"

#include <QList>
#include <QSslCertificate>
#include <QSslError>
#include <QSslKey>

#include <filesystem>

namespace carina
{

/// The certificate by which a host authenticates, where it has one.
struct HostCertificate {
    QList<QSslCertificate> chain; ///< the host's own first, then the intermediate ones
    QSslKey key;
    std::string name; ///< host name or address of the certificate that guests are to expect

    /// Reads PEM files. @returns the errors of reading a file; FileMalformed for a file without
    /// certificate or without an unencrypted key, or a certificate not for a host;
    /// CertificateExpired, also before its validity begins; KeyDoesNotFit.
    [[nodiscard]] static Result<HostCertificate> read(const std::filesystem::path& certificate,
                                                      const std::filesystem::path& privateKey);
};

/// What a client requires of the host's certificate.
struct ExpectedCertificate {
    QString name; ///< a host name or an address
    QList<QSslCertificate> authorities;

    /// @param authorities a PEM file; empty: those that the system trusts
    /// @returns the errors of reading the file; FileMalformed for one without a certificate.
    [[nodiscard]] static Result<ExpectedCertificate> read(const std::string& name,
                                                          const std::filesystem::path& authorities);
};

/// SHA-256 of a certificate in DER.
[[nodiscard]] CertificateDigest digestOf(const QSslCertificate& certificate);

/// The most serious fault of a certificate that was not accepted: CertificateUntrusted,
/// CertificateExpired or CertificateOfAnother, in this order.
[[nodiscard]] Error certificateFault(const QList<QSslError>& errors, const QString& expectedName);

} // namespace carina
