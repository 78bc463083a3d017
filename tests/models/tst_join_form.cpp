#include "models/join_form.h"

#include <QTest>

namespace carina
{

class JoinFormTest : public QObject
{
    Q_OBJECT

private:
    static JoinForm complete()
    {
        return {QStringLiteral("192.0.2.7"), QStringLiteral("45000"), QStringLiteral("7k3qm xw2pd"),
                QStringLiteral("Anna"), Role::Trainee};
    }

private Q_SLOTS:
    void completeFormIsTakenOver()
    {
        JoinForm form = complete();
        form.name = QStringLiteral("  Anna ");
        form.role = Role::Observer;
        QCOMPARE(whatIsMissing(form), QString{});
        JoinSettings settings;
        fillIn(settings, form);
        QCOMPARE(settings.participantName, std::string{"Anna"});
        QCOMPARE(settings.address, std::string{"192.0.2.7"});
        QCOMPARE(settings.port, std::uint16_t{45000});
        QVERIFY(settings.role == Role::Observer);
        QCOMPARE(settings.code->text(), std::string{"7K3QM-XW2PD"});
    }

    void codeMayBeEmptyForOneWhoComesBack()
    {
        JoinForm form = complete();
        form.code = QStringLiteral(" ");
        QCOMPARE(whatIsMissing(form), QString{});
        JoinSettings settings;
        settings.code = JoinCode::random();
        fillIn(settings, form);
        QVERIFY(!settings.code);
    }

    void saysWhatToMend_data()
    {
        QTest::addColumn<QByteArray>("address");
        QTest::addColumn<QByteArray>("port");
        QTest::addColumn<QByteArray>("code");
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("word");
        const char* const good = "192.0.2.7";
        QTest::newRow("no name") << QByteArray{good} << QByteArray{"1"} << QByteArray{""}
                                 << QByteArray{"  "} << QByteArray{"name"};
        QTest::newRow("a name of 65 letters")
            << QByteArray{good} << QByteArray{"1"} << QByteArray{""} << QByteArray(65, 'a')
            << QByteArray{"shorter"};
        QTest::newRow("no address") << QByteArray{""} << QByteArray{"1"} << QByteArray{""}
                                    << QByteArray{"A"} << QByteArray{"address"};
        QTest::newRow("a name as address")
            << QByteArray{"ward three"} << QByteArray{"1"} << QByteArray{""} << QByteArray{"A"}
            << QByteArray{"address"};
        QTest::newRow("no port") << QByteArray{good} << QByteArray{""} << QByteArray{""}
                                 << QByteArray{"A"} << QByteArray{"port"};
        QTest::newRow("port 0") << QByteArray{good} << QByteArray{"0"} << QByteArray{""}
                                << QByteArray{"A"} << QByteArray{"port"};
        QTest::newRow("port 65536") << QByteArray{good} << QByteArray{"65536"} << QByteArray{""}
                                    << QByteArray{"A"} << QByteArray{"port"};
        QTest::newRow("a word as port") << QByteArray{good} << QByteArray{"four"} << QByteArray{""}
                                        << QByteArray{"A"} << QByteArray{"port"};
        QTest::newRow("half a code") << QByteArray{good} << QByteArray{"1"} << QByteArray{"7K3QM"}
                                     << QByteArray{"A"} << QByteArray{"code"};
    }

    void saysWhatToMend()
    {
        QFETCH(const QByteArray, address);
        QFETCH(const QByteArray, port);
        QFETCH(const QByteArray, code);
        QFETCH(const QByteArray, name);
        QFETCH(const QByteArray, word);
        const QString missing =
            whatIsMissing({QString::fromUtf8(address), QString::fromUtf8(port),
                           QString::fromUtf8(code), QString::fromUtf8(name), Role::Trainee});
        QVERIFY2(missing.contains(QString::fromUtf8(word)), qPrintable(missing));
    }

    void linkInThePlaceOfTheAddressIsRead()
    {
        const JoinForm typed{QStringLiteral(" carina:join?address=2001:db8::1&port=45001"
                                            "&role=observer&code=7K3QM-XW2PD "),
                             {},
                             {},
                             QStringLiteral("Anna"),
                             Role::Trainee};
        const JoinForm read = withLinkRead(typed);
        QCOMPARE(whatIsMissing(read), QString{});
        QCOMPARE(read.address, QStringLiteral("2001:db8::1"));
        QCOMPARE(read.port, QStringLiteral("45001"));
        QCOMPARE(read.code, QStringLiteral("7K3QM-XW2PD"));
        QCOMPARE(read.name, QStringLiteral("Anna"));
        QVERIFY(read.role == Role::Observer);
    }

    void certificateThatIsExpectedStaysExpected()
    {
        JoinForm form = complete();
        JoinSettings settings;
        fillIn(settings, form);
        QVERIFY(!settings.certificate);
        form.certificate = QStringLiteral(" carina.example ");
        QCOMPARE(whatIsMissing(form), QString{});
        settings.certificate = ExpectedHost{{}, "authority.pem"};
        fillIn(settings, form);
        QCOMPARE(settings.certificate->name, std::string{"carina.example"});
        QCOMPARE(settings.certificate->authority.string(), std::string{"authority.pem"});
        form.certificate.clear();
        fillIn(settings, form);
        QVERIFY(settings.certificate);
        QCOMPARE(settings.certificate->name, std::string{}); // the address
        settings.certificate.reset();
        form.certificate = QStringLiteral("192.0.2.7");
        fillIn(settings, form);
        QCOMPARE(settings.certificate->name, std::string{"192.0.2.7"});
        form.certificate = QStringLiteral("ward three");
        QVERIFY(whatIsMissing(form).contains(QStringLiteral("certificate")));
    }

    void linkNamesTheCertificateToExpect()
    {
        JoinForm form = complete();
        form.address = QStringLiteral("carina:join?address=192.0.2.7&port=1&role=trainee"
                                      "&code=7K3QM-XW2PD&certificate=carina.example");
        QCOMPARE(withLinkRead(form).certificate, QStringLiteral("carina.example"));
    }

    void whatIsNoLinkStaysAsItIs()
    {
        for (const char* address : {"192.0.2.7", "carina:join?port=1", "ward three", ""}) {
            JoinForm form = complete();
            form.address = QLatin1String{address};
            const JoinForm read = withLinkRead(form);
            QCOMPARE(read.address, form.address);
            QCOMPARE(read.port, form.port);
            QCOMPARE(read.code, form.code);
        }
    }

    void wrongLinkIsNamedBeforeAnythingElse()
    {
        JoinForm form = complete();
        form.address = QStringLiteral("carina:join?port=1");
        form.name.clear();
        const QString missing = whatIsMissing(form);
        QVERIFY2(missing.contains(QStringLiteral("it has no address")), qPrintable(missing));
    }

    void everyPortAndAddressThatThereIsWillDo()
    {
        JoinForm form = complete();
        form.address = QStringLiteral("2001:db8::1");
        for (const char* port : {"1", "65535"}) {
            form.port = QLatin1String{port};
            QCOMPARE(whatIsMissing(form), QString{});
        }
        form.name = QString(64, QLatin1Char{'a'});
        QCOMPARE(whatIsMissing(form), QString{});
    }
};

} // namespace carina

QTEST_GUILESS_MAIN(carina::JoinFormTest)
#include "tst_join_form.moc"
