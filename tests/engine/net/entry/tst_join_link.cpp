#include "engine/net/discovery/addresses.h"
#include "engine/net/entry/join_link.h"
#include "tests/support/test_class.h"

#include <QUrl>
#include <QUrlQuery>

#include <random>

namespace carina::join_link_test
{
namespace
{

const std::string kLink = "carina:join?address=192.0.2.7&port=45000&role=observer&code=7K3QM-XW2PD";

JoinLink wardThree()
{
    return {"192.0.2.7", 45000, Role::Observer, *JoinCode::parse("7K3QMXW2PD")};
}

} // namespace

class TestJoinLink : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isWrittenAndRead()
    {
        QCOMPARE(toText(wardThree()), kLink);
        QVERIFY(joinLink(kLink) == wardThree());
        const JoinLink far{"2001:db8::7", 65535, Role::Trainee, JoinCode::random()};
        QVERIFY(joinLink(toText(far)) == far);
    }

    void mayNameTheCertificateToExpect()
    {
        JoinLink link = wardThree();
        link.certificate = "carina.hospital.example";
        QCOMPARE(toText(link), kLink + "&certificate=carina.hospital.example");
        QVERIFY(joinLink(toText(link)) == link);
        for (const std::string& name :
             {std::string{"2001:db8::7"}, std::string{"A-0.z"}, std::string(253, 'a')}) {
            link.certificate = name;
            QVERIFY(joinLink(toText(link)) == link);
        }
        link.certificate = std::string(254, 'a');
        QCOMPARE(joinLink(toText(link)).error().detail,
                 std::string{"its certificate is for no host"});
    }

    void isAUrlLikeAnyOther()
    {
        const QUrl url{QString::fromStdString(kLink), QUrl::StrictMode};
        QVERIFY(url.isValid());
        QCOMPARE(url.scheme(), QStringLiteral("carina"));
        const QUrlQuery query{url};
        QCOMPARE(query.queryItemValue(QStringLiteral("address")), QStringLiteral("192.0.2.7"));
        QCOMPARE(query.queryItemValue(QStringLiteral("code")), QStringLiteral("7K3QM-XW2PD"));
    }

    void partsMayComeInAnyOrderAndBlanksAround()
    {
        QVERIFY(
            joinLink(" carina:join?code=7k3qmxw2pd&role=observer&port=45000&address=192.0.2.7\n")
            == wardThree());
    }

    void tellsALinkFromAnAddress()
    {
        QVERIFY(isMeantAsLink(kLink));
        QVERIFY(isMeantAsLink("\t carina:"));
        QVERIFY(!isMeantAsLink("192.0.2.7"));
        QVERIFY(!isMeantAsLink("carina"));
        QVERIFY(!isMeantAsLink(""));
        QVERIFY(!isMeantAsLink("  "));
    }

    void saysWhatIsWrong_data()
    {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QByteArray>("what");
        const auto row = [](const char* name, const char* from, const char* to, const char* what) {
            QTest::newRow(name) << QByteArray{from} << QByteArray{to} << QByteArray{what};
        };
        const char* const begin = "it does not begin with carina:join?";
        row("another scheme", "carina:", "https:", begin);
        row("another verb", "join?", "leave?", begin);
        row("no parts", "?", "", begin);
        row("a part of tomorrow", "&port", "&colour=blue&port", "a part of it is unknown");
        row("a part without a value", "&port", "&colour&port", "a part of it is unknown");
        row("a name without a value", "port=45000", "port", "a part of it is unknown");
        row("an empty part", "&port", "&&port", "a part of it is unknown");
        row("two ports", "port=45000", "port=1&port=2", "its port is there twice");
        row("two ports, one empty", "port=", "port=&port=", "its port is there twice");
        row("no address", "address=192.0.2.7&", "", "it has no address");
        row("a name as address", "192.0.2.7", "ward three", "it has no address");
        row("an address and a blank", "192.0.2.7", "192.0.2.7 ", "it has no address");
        row("a blank and an address", "192.0.2.7", "\u00a0192.0.2.7", "it has no address");
        row("no port", "port=45000&", "", "it has no port");
        row("port 0", "45000", "0", "it has no port");
        row("port 65536", "45000", "65536", "it has no port");
        row("half a port", "45000", "450x", "it has no port");
        row("a negative port", "45000", "-1", "it has no port");
        const char* const role = "it is for neither a trainee nor an observer";
        row("no role", "role=observer&", "", role);
        row("another role", "observer", "surgeon", role);
        row("an instructor", "observer", "instructor", role);
        const char* const code = "it has no code of ten letters and digits";
        const char* const host = "its certificate is for no host";
        row("no name", "&role", "&certificate=&role", host);
        row("a name with a blank", "&role", "&certificate=ward three&role", host);
        row("a name with a letter beyond ASCII", "&role", "&certificate=\xc3\xa9&role", host);
        row("an address and a blank as name", "&role", "&certificate=192.0.2.7 &role", host);
        row("no code", "&code=7K3QM-XW2PD", "", code);
        row("half a code", "-XW2PD", "", code);
    }
    void saysWhatIsWrong()
    {
        QFETCH(const QByteArray, from);
        QFETCH(const QByteArray, to);
        QFETCH(const QByteArray, what);
        QByteArray text = QByteArray::fromStdString(kLink);
        QVERIFY(text.contains(from));
        const auto link = joinLink(text.replace(from, to).toStdString());
        QVERIFY(!link);
        QCOMPARE(link.error(), (Error{Errc::WrongLink, what.toStdString()}));
    }

    void isNoLongerThanItMayBe()
    {
        // An IPv6 address may name its interface, however long.
        const std::string begin =
            "carina:join?port=1&role=trainee&code=7K3QM-XW2PD&address=fe80::1%";
        const std::string longest = begin + std::string(JoinLink::kLongest - begin.size(), 'e');
        QVERIFY(joinLink(longest));
        QCOMPARE(joinLink(longest + 'e').error(), (Error{Errc::WrongLink, "it is too long"}));
    }

    void mutatedLinksAreRefusedOrSound()
    {
        constexpr int kMutatedLinks = 100'000;
        std::mt19937 random{7};
        const auto below = [&random](std::size_t n) { return random() % n; };
        int accepted = 0;
        for (int i = 0; i < kMutatedLinks; ++i) {
            std::string text = kLink;
            for (std::size_t change = 0; change <= below(3); ++change) {
                const std::size_t at = below(text.size());
                switch (below(4)) {
                case 0:
                    text[at] = static_cast<char>(below(256));
                    break;
                case 1:
                    text.erase(at, below(8));
                    break;
                case 2:
                    text.insert(at, text.substr(below(text.size()), below(40)));
                    break;
                default:
                    text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
                }
                text += text.empty() ? "c" : "";
            }
            const auto link = joinLink(text);
            if (!link) {
                QCOMPARE(link.error().code, Errc::WrongLink);
                continue;
            }
            ++accepted;
            QVERIFY(isAddress(link->address) && link->port != 0 && link->role != Role::Instructor);
            QVERIFY(joinLink(toText(*link)) == *link);
        }
        // Neither everything nor nothing: some changes make another link.
        QVERIFY(accepted > kMutatedLinks / 100);
        QVERIFY(accepted < kMutatedLinks / 2);
    }
};

CARINA_TEST(TestJoinLink)

} // namespace carina::join_link_test

#include "tst_join_link.moc"
