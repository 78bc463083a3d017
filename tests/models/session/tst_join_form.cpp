#include "engine/net/entry/session_identity.h"
#include "engine/net/entry/token_folder.h"
#include "models/errors/error_text.h"
#include "models/session/join_form.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

namespace carina::join_form_test
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

    static QString missingIn(const JoinForm& form)
    {
        const auto missing = whatIsMissing(form, {});
        return missing ? missing->sentence : QString{};
    }

private Q_SLOTS:
    void completeFormIsTakenOver()
    {
        JoinForm form = complete();
        form.name = QStringLiteral("  Anna ");
        form.role = Role::Observer;
        form.station = QStringLiteral(" Room 5 ");
        QCOMPARE(missingIn(form), QString{});
        JoinSettings settings;
        fillIn(settings, form);
        QCOMPARE(settings.participantName, std::string{"Anna"});
        QCOMPARE(settings.address, std::string{"192.0.2.7"});
        QCOMPARE(settings.port, std::uint16_t{45000});
        QVERIFY(settings.role == Role::Observer);
        QCOMPARE(settings.station, std::string{"Room 5"});
        QCOMPARE(formOf(settings).station, QStringLiteral("Room 5"));
        form.station = QString{65, QLatin1Char('x')};
        QCOMPARE(whatIsMissing(form, {})->field, JoinField::Station);
        QCOMPARE(settings.code->text(), std::string{"7K3QM-XW2PD"});
    }

    void codeMayBeEmptyOnlyForOneWhoComesBack()
    {
        const QTemporaryDir tokens;
        const std::filesystem::path folder = tokens.path().toStdString();
        JoinForm form = complete();
        form.code = QStringLiteral(" ");
        QCOMPARE(whatIsMissing(form, folder)->field, JoinField::Code);
        QVERIFY(TokenFolder(folder, Role::Trainee, "Anna").keep(std::string(32, 'a'), {}));
        QVERIFY(!whatIsMissing(form, folder));
        form.role = Role::Observer;
        QCOMPARE(whatIsMissing(form, folder)->field, JoinField::Code);
        form.role = Role::Trainee;
        form.name = QStringLiteral("Anne");
        QCOMPARE(whatIsMissing(form, folder)->field, JoinField::Code);
        QCOMPARE(whatIsMissing(form, {})->field, JoinField::Code);
        JoinSettings settings;
        settings.code = JoinCode::random();
        fillIn(settings, form);
        QVERIFY(!settings.code);
    }

    void refusalLeadsToTheFieldThatIsWrong_data()
    {
        QTest::addColumn<Errc>("why");
        QTest::addColumn<JoinField>("field");
        QTest::newRow("code") << Errc::WrongCode << JoinField::Code;
        QTest::newRow("memory") << Errc::NotEnoughMemory << JoinField::Code;
        QTest::newRow("name") << Errc::NameTaken << JoinField::Name;
        QTest::newRow("expired") << Errc::CertificateExpired << JoinField::Certificate;
        QTest::newRow("untrusted") << Errc::CertificateUntrusted << JoinField::Certificate;
        QTest::newRow("another's") << Errc::CertificateOfAnother << JoinField::Certificate;
        QTest::newRow("no certificate") << Errc::CertificateMissing << JoinField::Certificate;
        QTest::newRow("a certificate") << Errc::CertificateNeeded << JoinField::Certificate;
        QTest::newRow("station") << Errc::StationUnknown << JoinField::Station;
        QTest::newRow("version") << Errc::VersionMismatch << JoinField::Address;
    }

    void refusalLeadsToTheFieldThatIsWrong()
    {
        QFETCH(const Errc, why);
        QFETCH(const JoinField, field);
        const JoinGap gap = gapOf({why, "this"}, complete());
        QCOMPARE(gap.field, field);
        QCOMPARE(gap.sentence, errorText({why, "this"}));
    }

    void codeThatWasNotTypedIsAskedForAndNotCalledWrong()
    {
        JoinForm form = complete();
        form.code.clear();
        const JoinGap gap = gapOf({Errc::WrongCode, {}}, form);
        QCOMPARE(gap.field, JoinField::Code);
        QCOMPARE(gap.sentence, whatIsMissing(form, {})->sentence);
    }

    void settingsAreShownAsTheyWouldBeTyped()
    {
        JoinSettings settings;
        const JoinForm none = formOf(settings);
        QCOMPARE(none.address, QStringLiteral("127.0.0.1"));
        QCOMPARE(none.port, QString{});
        QCOMPARE(none.code, QString{});
        QCOMPARE(none.certificate, QString{});
        JoinForm form = complete();
        form.role = Role::Observer;
        form.certificate = QStringLiteral("carina.example");
        fillIn(settings, form);
        const JoinForm shown = formOf(settings);
        QCOMPARE(shown.address, form.address);
        QCOMPARE(shown.port, form.port);
        QCOMPARE(shown.code, QStringLiteral("7K3QM-XW2PD"));
        QCOMPARE(shown.name, form.name);
        QVERIFY(shown.role == Role::Observer);
        QCOMPARE(shown.certificate, form.certificate);
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
        QTest::newRow("no code") << QByteArray{good} << QByteArray{"1"} << QByteArray{" "}
                                 << QByteArray{"A"} << QByteArray{"code of your role"};
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
            missingIn({QString::fromUtf8(address), QString::fromUtf8(port), QString::fromUtf8(code),
                       QString::fromUtf8(name), Role::Trainee});
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
        QCOMPARE(missingIn(read), QString{});
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
        QCOMPARE(missingIn(form), QString{});
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
        QVERIFY(missingIn(form).contains(QStringLiteral("certificate")));
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
        const QString missing = missingIn(form);
        QVERIFY2(missing.contains(QStringLiteral("it has no address")), qPrintable(missing));
    }

    void everyPortAndAddressThatThereIsWillDo()
    {
        JoinForm form = complete();
        form.address = QStringLiteral("2001:db8::1");
        for (const char* port : {"1", "65535"}) {
            form.port = QLatin1String{port};
            QCOMPARE(missingIn(form), QString{});
        }
        form.name = QString(64, QLatin1Char{'a'});
        QCOMPARE(missingIn(form), QString{});
    }

    void personOfTheLastTimeIsKept()
    {
        const QTemporaryDir folder;
        const std::filesystem::path tokens{folder.path().toStdString()};
        QCOMPARE(withLastPerson({}, tokens).name, QString{});
        keepLastTime(tokens, {.name = QStringLiteral(" Änne Müller "),
                              .role = Role::Observer,
                              .certificate = QStringLiteral("carina.example")});
        const JoinForm form = withLastPerson({}, tokens);
        QCOMPARE(form.name, QStringLiteral("Änne Müller"));
        QVERIFY(form.role == Role::Observer);
        QCOMPARE(form.certificate, QStringLiteral("carina.example"));
        const JoinForm ben = withLastPerson({.name = QStringLiteral("Ben")}, tokens);
        QCOMPARE(ben.name, QStringLiteral("Ben"));
        QVERIFY(ben.role == Role::Trainee && ben.certificate.isEmpty());
    }

    /// Where a token says that the person may come into it again.
    void sessionOfTheLastTimeIsKnown()
    {
        const QTemporaryDir folder;
        const std::filesystem::path tokens{folder.path().toStdString()};
        const std::string session(32, 'a');
        const JoinForm anna{.name = QStringLiteral("Anna")};
        TokenFolder kept{tokens, Role::Trainee, "Anna"};
        QVERIFY(kept.keepVisit({session, "192.0.2.7", 45000}));
        QVERIFY(!lastSession(anna, tokens));
        QCOMPARE(withLastPlace(anna, tokens).address, QString{});
        QVERIFY(kept.keep(session, {}));
        QVERIFY(lastSession(anna, tokens) == sessionKey(session));
        const JoinForm form = withLastPlace(anna, tokens);
        QCOMPARE(form.address, QStringLiteral("192.0.2.7"));
        QCOMPARE(form.port, QStringLiteral("45000"));
        QVERIFY(form.isPlaceOfLastTime);
        QVERIFY(!whatIsMissing(form, tokens));
        const JoinForm told = withLastPlace(
            {.address = QStringLiteral("192.0.2.8"), .name = QStringLiteral("Anna")}, tokens);
        QCOMPARE(told.address, QStringLiteral("192.0.2.8"));
        QVERIFY(!told.isPlaceOfLastTime);
        QVERIFY(!lastSession({.name = QStringLiteral("Ben")}, tokens));
    }
};

CARINA_TEST(JoinFormTest)

} // namespace carina::join_form_test

#include "tst_join_form.moc"
