#include "engine/net/entry/certificates.h"
#include "tests/engine/net/entry/made_certificates.h"
#include "tests/support/test_class.h"

namespace carina::certificates_test
{

class TestCertificates : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        if (!MadeCertificates::canBeMade())
            return;
        m_made = std::make_unique<MadeCertificates>();
        m_made->make(QStringLiteral("host"));
        m_made->make(QStringLiteral("rsa"), {.rsa = true});
    }

    void init()
    {
        if (!m_made)
            QSKIP("the program openssl is not installed");
    }

    void hostsOwnIsReadWithItsKey_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::newRow("elliptic curve") << QByteArray{"host"};
        QTest::newRow("RSA") << QByteArray{"rsa"};
    }
    void hostsOwnIsReadWithItsKey()
    {
        QFETCH(const QByteArray, name);
        const auto read = HostCertificate::read(m_made->certificate(name), m_made->key(name));
        QVERIFY2(read, read ? "" : read.error().detail.c_str());
        QCOMPARE(read->chain.size(), 1);
        QCOMPARE(read->name, std::string{"carina.example"});
    }

    void nameToExpectIsTheFirstThatItIsFor_data()
    {
        QTest::addColumn<QString>("hosts");
        QTest::addColumn<QByteArray>("name");
        QTest::newRow("a name") << QStringLiteral("IP:192.0.2.7,DNS:b.example")
                                << QByteArray{"b.example"};
        QTest::newRow("an address") << QStringLiteral("IP:192.0.2.7") << QByteArray{"192.0.2.7"};
        QTest::newRow("all of a domain")
            << QStringLiteral("DNS:*.ward.example") << QByteArray{"carina.ward.example"};
    }
    void nameToExpectIsTheFirstThatItIsFor()
    {
        QFETCH(const QString, hosts);
        QFETCH(const QByteArray, name);
        m_made->make(QStringLiteral("named"), {.hosts = hosts});
        const auto read = HostCertificate::read(m_made->certificate("named"), m_made->key("named"));
        QVERIFY(read);
        QCOMPARE(read->name, name.toStdString());
    }

    void digestIsThatOfTheOpensslProgram()
    {
        QProcess openssl;
        openssl.start(QStringLiteral("openssl"),
                      {QStringLiteral("x509"), QStringLiteral("-in"),
                       m_made->path(QStringLiteral("host"), "pem"), QStringLiteral("-noout"),
                       QStringLiteral("-fingerprint"), QStringLiteral("-sha256")});
        QVERIFY(openssl.waitForFinished());
        const QByteArray told = openssl.readAllStandardOutput().trimmed();
        const auto read = HostCertificate::read(m_made->certificate("host"), m_made->key("host"));
        const QByteArray hex = QByteArray::fromStdString(toHex(digestOf(read->chain.first())));
        QCOMPARE(told.mid(told.indexOf('=') + 1).replace(":", "").toLower(), hex);
    }

    void whatDoesNotDoIsRefused_data()
    {
        QTest::addColumn<QByteArray>("certificate");
        QTest::addColumn<QByteArray>("key");
        QTest::addColumn<int>("code");
        QTest::addColumn<QByteArray>("says");
        const auto row = [](const char* name, const char* certificate, const char* key, Errc code,
                            const char* says) {
            QTest::newRow(name) << QByteArray{certificate} << QByteArray{key} << int(code)
                                << QByteArray{says};
        };
        row("no such certificate", "nobody", "host", Errc::FileNotFound, "nobody.pem");
        row("no such key", "host", "nobody", Errc::FileNotFound, "nobody.key");
        row("key of another", "host", "ours", Errc::KeyDoesNotFit, "ours.key");
        row("key of another kind", "host", "rsa", Errc::KeyDoesNotFit, "rsa.key");
        row("over", "over", "over", Errc::CertificateExpired, "over.pem");
        row("for no host", "mail", "mail", Errc::FileMalformed, "for no host");
        row("key with a password", "locked", "locked", Errc::FileMalformed, "without a password");
        row("text as certificate", "text", "host", Errc::FileMalformed, "no certificate");
        row("certificate as key", "host", "swapped", Errc::FileMalformed, "no private key");
    }
    void whatDoesNotDoIsRefused()
    {
        QFETCH(const QByteArray, certificate);
        QFETCH(const QByteArray, key);
        QFETCH(const int, code);
        QFETCH(const QByteArray, says);
        const auto copy = [this](const char* from, const char* to) {
            QFile::copy(m_made->path(QLatin1String{from}, "pem"), QLatin1String{to});
        };
        if (certificate == "over")
            m_made->make(QStringLiteral("over"), {.days = -1});
        if (certificate == "mail")
            m_made->make(QStringLiteral("mail"), {.hosts = QStringLiteral("email:a@b.example")});
        copy("host", qPrintable(m_made->path(QStringLiteral("locked"), "pem")));
        copy("host", qPrintable(m_made->path(QStringLiteral("swapped"), "key")));
        if (certificate == "locked")
            m_made->run({QStringLiteral("pkcs8"), QStringLiteral("-topk8"), QStringLiteral("-in"),
                         m_made->path(QStringLiteral("host"), "key"), QStringLiteral("-passout"),
                         QStringLiteral("pass:secret"), QStringLiteral("-out"),
                         m_made->path(QStringLiteral("locked"), "key")});
        QFile text{m_made->path(QStringLiteral("text"), "pem")};
        QVERIFY(text.open(QIODevice::WriteOnly));
        text.write("-----BEGIN CERTIFICATE-----\nhello\n");
        text.close();

        const auto read = HostCertificate::read(m_made->certificate(certificate), m_made->key(key));
        QVERIFY(!read);
        QCOMPARE(int(read.error().code), code);
        QVERIFY2(QByteArray::fromStdString(read.error().detail).contains(says),
                 read.error().detail.c_str());
    }

    void authoritiesAreReadFromAFileOrTheSystem()
    {
        const auto ours = ExpectedCertificate::read("b.example", m_made->certificate("ours"));
        QVERIFY(ours);
        QCOMPARE(ours->authorities.size(), 1);
        QCOMPARE(ours->name, QStringLiteral("b.example"));
        const auto systems = ExpectedCertificate::read("b.example", {});
        QVERIFY(systems);
        QVERIFY(!systems->authorities.contains(ours->authorities.first()));
        QCOMPARE(ExpectedCertificate::read("b.example", "/no/such/file").error().code,
                 Errc::FileNotFound);
        QCOMPARE(ExpectedCertificate::read("b.example", m_made->key("ours")).error().code,
                 Errc::FileMalformed);
    }

    void gravestFaultIsTold()
    {
        using E = QSslError;
        const QString name = QStringLiteral("b.example");
        const auto code = [&](const QList<QSslError>& errors) {
            return certificateFault(errors, name).code;
        };
        const QSslError over{E::CertificateExpired};
        const QSslError early{E::CertificateNotYetValid};
        const QSslError another{E::HostNameMismatch};
        const QSslError unknown{E::UnableToGetLocalIssuerCertificate};
        QCOMPARE(code({over}), Errc::CertificateExpired);
        QCOMPARE(code({early}), Errc::CertificateExpired);
        QCOMPARE(code({another}), Errc::CertificateOfAnother);
        QCOMPARE(code({another, over}), Errc::CertificateExpired);
        QCOMPARE(code({another, over, unknown}), Errc::CertificateUntrusted);
        QCOMPARE(code({}), Errc::CertificateUntrusted);
        QVERIFY(certificateFault({another}, name).detail.find("b.example") != std::string::npos);
    }

private:
    std::unique_ptr<MadeCertificates> m_made;
};

CARINA_TEST(TestCertificates)

} // namespace carina::certificates_test

#include "tst_certificates.moc"
