#include "evaluation/network/netlab_network.h"
#include "tests/support/test_class.h"

namespace carina::netlab_network_test
{
namespace
{

QStringList linksOf(const char* scenario, std::size_t participants, bool hasStepped = false)
{
    return netlabLinks(*findScenario(scenario), participants, hasStepped, "trace.txt");
}

} // namespace

class NetlabNetworkTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachLegIsHalfOfAPath()
    {
        const QString leg =
            QStringLiteral("order=free delay=100000ns jitter=none loss=0 dup=0 reorder=0:0ns");
        QCOMPARE(linksOf("lan", 3), (QStringList{QStringLiteral("link p1>host ") + leg,
                                                 QStringLiteral("link host>p1 ") + leg,
                                                 QStringLiteral("link p2,p3>host ") + leg,
                                                 QStringLiteral("link host>p2,p3 ") + leg}));
    }

    void actorAndViewersSeeAPathFromItsTwoEnds()
    {
        const QStringList links = linksOf("asymmetric", 2);
        QVERIFY(links[0].contains(QLatin1StringView{" delay=12500000ns jitter=exp:1000000ns "}));
        QVERIFY(links[1].contains(QLatin1StringView{" delay=27500000ns "}));
        QVERIFY(links[2].contains(QLatin1StringView{" delay=27500000ns "}));
        QVERIFY(links[3].contains(QLatin1StringView{" delay=12500000ns "}));
    }

    void whatGoesWrongIsSaid_data()
    {
        QTest::addColumn<QByteArray>("scenario");
        QTest::addColumn<bool>("hasStepped");
        QTest::addColumn<QByteArray>("said");
        QTest::newRow("heavy tail") << QByteArray{"cellular"} << false
                                    << QByteArray{" jitter=pareto:4000000ns loss=0.0100505 "};
        QTest::newRow("even") << QByteArray{"paper"} << false
                              << QByteArray{" delay=47500000ns jitter=uniform:7142857ns "};
        QTest::newRow("before the step")
            << QByteArray{"step"} << false << QByteArray{" delay=4000000ns "};
        QTest::newRow("after the step")
            << QByteArray{"step"} << true << QByteArray{" delay=14000000ns "};
        QTest::newRow("bursts") << QByteArray{"burst"} << false << QByteArray{" ge=0.005:0.25"};
        QTest::newRow("bottleneck")
            << QByteArray{"bottleneck"} << false << QByteArray{" rate=1e+06 queue=32768"};
        QTest::newRow("duplication")
            << QByteArray{"duplication"} << false << QByteArray{" dup=0.0513167 "};
        QTest::newRow("reordering")
            << QByteArray{"reordering"} << false << QByteArray{" reorder=0.0253206:20000000ns"};
    }
    void whatGoesWrongIsSaid()
    {
        QFETCH(QByteArray, scenario);
        QFETCH(bool, hasStepped);
        QFETCH(QByteArray, said);
        for (const QString& link : linksOf(scenario.constData(), 2, hasStepped))
            QVERIFY2(link.contains(QString::fromLatin1(said)), qPrintable(link));
    }

    void missingProgramIsNamed()
    {
        const auto network =
            netlabNetwork(QStringLiteral("/nowhere/netlab"), 2, *findScenario("lan"), 1);
        QVERIFY(!network);
        QCOMPARE(network.error().code, Errc::NotPermitted);
    }
};

CARINA_TEST(NetlabNetworkTest)

} // namespace carina::netlab_network_test

#include "tst_netlab_network.moc"
