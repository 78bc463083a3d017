#pragma once

#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>

namespace carina
{

/// Certificates that the openssl program makes on the spot, so that they are of today. There are
/// two authorities, "ours" and "another".
class MadeCertificates
{
public:
    [[nodiscard]] static bool canBeMade()
    {
        return !QStandardPaths::findExecutable(QStringLiteral("openssl")).isEmpty();
    }

    MadeCertificates()
    {
        for (const QString& name : {QStringLiteral("ours"), QStringLiteral("another")}) {
            makeKey(name, false);
            run({QStringLiteral("req"), QStringLiteral("-x509"), QStringLiteral("-new"),
                 QStringLiteral("-key"), path(name, "key"), QStringLiteral("-subj"),
                 QStringLiteral("/CN=Authority ") + name, QStringLiteral("-days"),
                 QStringLiteral("2"), QStringLiteral("-out"), path(name, "pem")});
        }
    }

    struct Wanted {
        QString hosts = QStringLiteral("DNS:carina.example,IP:127.0.0.1");
        QString authority = QStringLiteral("ours");
        int days = 2; ///< below 0: over since yesterday
        bool rsa = false;
    };
    /// NAME.pem and NAME.key of a host.
    void make(const QString& name) { make(name, Wanted{}); }
    void make(const QString& name, const Wanted& wanted)
    {
        makeKey(name, wanted.rsa);
        QFile extension{path(name, "ext")};
        QVERIFY(extension.open(QIODevice::WriteOnly));
        extension.write("subjectAltName=" + wanted.hosts.toUtf8() + "\n");
        extension.close();
        run({QStringLiteral("req"), QStringLiteral("-new"), QStringLiteral("-key"),
             path(name, "key"), QStringLiteral("-subj"), QStringLiteral("/CN=A host"),
             QStringLiteral("-out"), path(name, "csr")});
        run({QStringLiteral("x509"), QStringLiteral("-req"), QStringLiteral("-in"),
             path(name, "csr"), QStringLiteral("-CA"), path(wanted.authority, "pem"),
             QStringLiteral("-CAkey"), path(wanted.authority, "key"),
             QStringLiteral("-CAcreateserial"), QStringLiteral("-days"),
             QString::number(wanted.days), QStringLiteral("-extfile"), path(name, "ext"),
             QStringLiteral("-out"), path(name, "pem")});
    }

    [[nodiscard]] QString path(const QString& name, const char* suffix) const
    {
        return m_folder.filePath(name + QLatin1Char{'.'} + QLatin1String{suffix});
    }
    [[nodiscard]] std::filesystem::path certificate(const char* name) const
    {
        return path(QLatin1String{name}, "pem").toStdString();
    }
    [[nodiscard]] std::filesystem::path key(const char* name) const
    {
        return path(QLatin1String{name}, "key").toStdString();
    }
    void run(const QStringList& arguments) const
    {
        QProcess openssl;
        openssl.start(QStringLiteral("openssl"), arguments);
        QVERIFY(openssl.waitForFinished());
        QVERIFY2(openssl.exitCode() == 0, openssl.readAllStandardError().constData());
    }

private:
    void makeKey(const QString& name, bool rsa) const
    {
        const QStringList kind =
            rsa ? QStringList{QStringLiteral("RSA"), QStringLiteral("-pkeyopt"),
                              QStringLiteral("rsa_keygen_bits:2048")}
                : QStringList{QStringLiteral("EC"), QStringLiteral("-pkeyopt"),
                              QStringLiteral("ec_paramgen_curve:P-256")};
        run(QStringList{QStringLiteral("genpkey"), QStringLiteral("-out"), path(name, "key"),
                        QStringLiteral("-algorithm")}
            + kind);
    }

    QTemporaryDir m_folder;
};

} // namespace carina
