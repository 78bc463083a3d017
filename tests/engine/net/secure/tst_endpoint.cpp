#include "engine/net/secure/endpoint.h"
#include "tests/support/test_class.h"

namespace carina::endpoint_test
{

class TestEndpoint : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void mappedAddressesAreTheSamePeer()
    {
        const QHostAddress plain{QStringLiteral("192.0.2.7")};
        const QHostAddress mapped{QStringLiteral("::ffff:192.0.2.7")};
        QVERIFY(endpoint(plain, 5) == endpoint(mapped, 5));
        QVERIFY(endpoint(plain, 5) != endpoint(plain, 6));
        QVERIFY(endpoint(plain, 5) != endpoint(QHostAddress{QStringLiteral("192.0.2.8")}, 5));
        QCOMPARE(normalised(mapped), plain);
        QCOMPARE(normalised(mapped).protocol(), QAbstractSocket::IPv4Protocol);
        const QHostAddress ipv6{QStringLiteral("2001:db8::1")};
        QCOMPARE(normalised(ipv6), ipv6);
    }

    void neighboursInAnIpv6NetworkAreOneSource()
    {
        const auto prefix = [](const char* address) {
            return sourcePrefix(endpoint(QHostAddress{QLatin1String{address}}, 1));
        };
        QVERIFY(prefix("2001:db8::1") == prefix("2001:db8::ffff:2"));
        QVERIFY(prefix("2001:db8::1") != prefix("2001:db8:0:1::1"));
        QVERIFY(prefix("192.0.2.7") != prefix("192.0.2.8"));
    }
};

CARINA_TEST(TestEndpoint)

} // namespace carina::endpoint_test

#include "tst_endpoint.moc"
