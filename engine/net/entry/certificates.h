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

/// By what a host proves itself, where it has a certificate.
struct HostCertificate {
    QList<QSslCertificate> chain; ///< its own first, then those that lead to an authority
    QSslKey key;
    std::string name; ///< that guests are told to expect: a host name or an address it is for

    /// From PEM files. @returns what reading a file does; FileMalformed for what holds no
    /// certificate or no key in the clear, or a certificate for no host; CertificateExpired, also
    /// before its time; KeyDoesNotFit.
    [[nodiscard]] static Result<HostCertificate> read(const std::filesystem::path& certificate,
                                                      const std::filesystem::path& privateKey);
};

/// What a client wants of the host's certificate.
struct ExpectedCertificate {
    QString name; ///< a host name or an address
    QList<QSslCertificate> authorities;

    /// @param authorities a PEM file; empty: those that the system trusts
    /// @returns what reading the file does; FileMalformed for one without a certificate.
    [[nodiscard]] static Result<ExpectedCertificate> read(const std::string& name,
                                                          const std::filesystem::path& authorities);
};

[[nodiscard]] CertificateDigest digestOf(const QSslCertificate& certificate);

/// What is wrong with a certificate that did not do, the gravest first: CertificateUntrusted,
/// CertificateExpired or CertificateOfAnother.
[[nodiscard]] Error certificateFault(const QList<QSslError>& errors, const QString& expectedName);

} // namespace carina
